#pragma once
// What holds for every tree of boxes.

#include <algorithm>
#include <rt/bounds.hpp>
#include <rt/tree.hpp>
#include <span>
#include <vector>

#include "scenes.hpp"

namespace checkpoint {

// Spheres with one center, with as many of them before and after the part of the order that is to
// be split, and at the ends two that are elsewhere. If std::sort is told that equal ones come
// before each other, it leaves the part.
template <class Split>
void check_equal_centers(const Split& split) {
    constexpr int part = 60, all = 3 * part;
    std::vector<Box> boxes(all, Box{{-1, -1, -1}, {1, 1, 1}});
    boxes.front() = Box{{-9, -9, -9}, {-8, -8, -8}};
    boxes.back() = Box{{8, 8, 8}, {9, 9, 9}};
    std::vector<int> before(all);
    for (int i = 0; i < all; ++i) before[static_cast<std::size_t>(i)] = i;
    std::vector<int> order = before;
    split(std::span{order}.subspan(part, part), std::span<const Box>{boxes});
    std::sort(order.begin() + part, order.begin() + 2 * part);
    INFO(
        "60 spheres have the same center. After sorting, this part of the order no longer holds "
        "the same IDs.\nHint: the lambda of std::sort compares with <. With <=, or with a "
        "difference, each of two equal centers comes before the other, and std::sort runs past "
        "the ends");
    REQUIRE((order == before));
}

inline int levels_of(const rt::TreeNode& node) {
    if (node.is_leaf()) return 1;
    return 1 + std::max(levels_of(*node.left), levels_of(*node.right));
}

inline int nodes_of(const rt::TreeNode& node) {
    return node.is_leaf() ? 1 : 1 + nodes_of(*node.left) + nodes_of(*node.right);
}

// How many spheres the leaves hold. From left to right they must follow each other in the order.
inline int check_places(const rt::TreeNode& node, int first) {
    if (!node.is_leaf()) {
        REQUIRE(node.right);
        const int left = check_places(*node.left, first);
        return left + check_places(*node.right, first + left);
    }
    if (node.first != first || node.count < 1) {
        INFO("a leaf holds "
             << node.count << " spheres from index " << node.first
             << " on; " EXPECTED "1 or more from index " << first
             << " on, where the leaves to the left of it end.\nHint: "
             << (node.first == first
                     ? "a leaf's count is order.size()"
                     : "the right part begins at first + how many went to the left"));
        REQUIRE(node.first == first);
        REQUIRE(node.count >= 1);
    }
    return node.count;
}

inline void check_node(const rt::TreeNode& node, const std::vector<int>& order,
                       const std::vector<Box>& boxes, std::vector<int>& leaves_of) {
    if (node.is_leaf()) {
        INFO("a leaf of " << node.count << " from index " << node.first << " on");
        REQUIRE_FALSE(node.right);
        REQUIRE(node.count >= 1);
        REQUIRE(node.first >= 0);
        REQUIRE(static_cast<std::size_t>(node.first + node.count) <= order.size());
        for (int place = node.first; place < node.first + node.count; ++place) {
            const auto sphere = static_cast<std::size_t>(order[static_cast<std::size_t>(place)]);
            ++leaves_of[sphere];
            if (node.box.contains(boxes[sphere])) continue;
            INFO("its " << text(node.box) << " does not contain its sphere's "
                        << text(boxes[sphere])
                        << ".\nHint: join boxes[id] for all IDs in order, and no others");
            REQUIRE(text(rt::join(node.box, boxes[sphere])) == text(node.box));
        }
        return;
    }
    REQUIRE(node.right);
    for (const rt::TreeNode* child : {node.left.get(), node.right.get()})
        if (!node.box.contains(child->box)) {
            INFO("a node's " << text(node.box) << " does not contain its child's "
                             << text(child->box)
                             << ".\nHint: join boxes[id] for all IDs in order, and pass "
                                "boxes on as it is: it belongs to the whole scene");
            REQUIRE(text(rt::join(node.box, child->box)) == text(node.box));
        }
    const Box both = rt::join(node.left->box, node.right->box);
    if (!(both == node.box)) {
        INFO("a node's " << text(node.box) << " is larger than its children's " << text(both)
                         << ".\nHint: join boxes[id] for the IDs in order, and no others");
        REQUIRE(text(node.box) == text(both));
    }
    check_node(*node.left, order, boxes, leaves_of);
    check_node(*node.right, order, boxes, leaves_of);
}

// Every sphere is in exactly one leaf, and each box contains what is below it, with nothing to
// spare.
inline void check_tree(const rt::TreeNode& root, const std::vector<int>& order,
                       const std::vector<Box>& boxes) {
    std::vector<int> sorted = order;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        INFO("the order must still hold every ID once");
        REQUIRE(sorted[i] == static_cast<int>(i));
    }
    const int held = check_places(root, 0);
    {
        INFO("the leaves hold " << held << " spheres of " << order.size()
                                << ".\nHint: a leaf's count is order.size(); first(n) and "
                                   "subspan(n) meet without a gap");
        REQUIRE(static_cast<std::size_t>(held) == order.size());
    }
    std::vector<int> leaves_of(boxes.size(), 0);
    check_node(root, order, boxes, leaves_of);
    for (std::size_t i = 0; i < leaves_of.size(); ++i) {
        INFO("sphere " << i << " is in " << leaves_of[i] << " leaves, not in 1");
        REQUIRE(leaves_of[i] == 1);
    }
}

}  // namespace checkpoint
