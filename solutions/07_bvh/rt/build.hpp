#pragma once
#include <algorithm>
#include <memory>
#include <rt/bounds.hpp>
#include <rt/tree.hpp>
#include <span>

namespace rt {

// Both functions work on a part of the tree's order: `order`, which holds the IDs of some
// spheres, whose boxes are boxes[id]. They move the IDs within `order` and copy nothing.

// Sorts the IDs by the centers of their boxes, along the axis on which these centers are
// farthest apart. Returns how many of the IDs go to the left: half, or 0 if there are at most
// leaf_size spheres, which need no split.
inline int split_in_half(std::span<int> order, std::span<const Box> boxes) {
    const auto count = static_cast<int>(order.size());
    if (count <= leaf_size) return 0;
    const auto middle = [&](int sphere) {
        return boxes[static_cast<std::size_t>(sphere)].center();
    };

    Box middles;
    for (const int sphere : order) middles = join(middles, {middle(sphere), middle(sphere)});
    const int axis = longest_axis(middles);
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return along(middle(a), axis) < along(middle(b), axis); });
    return count / 2;
}

// The tree over this part of the order, which begins at index `first` of the whole order. It has at
// least one ID. split(order, boxes) is split_in_half or a function like it. From level
// most_levels on, split_in_half is always used.
template <class Split>
std::unique_ptr<TreeNode> build_node(std::span<int> order, int first, std::span<const Box> boxes,
                                     const Split& split, int level = 0) {
    auto node = std::make_unique<TreeNode>();
    for (const int sphere : order)
        node->box = join(node->box, boxes[static_cast<std::size_t>(sphere)]);

    const int left = level < most_levels ? split(order, boxes) : split_in_half(order, boxes);
    if (left == 0) {
        node->first = first;
        node->count = static_cast<int>(order.size());
    } else {
        const auto cut = static_cast<std::size_t>(left);
        node->left = build_node(order.first(cut), first, boxes, split, level + 1);
        node->right = build_node(order.subspan(cut), first + left, boxes, split, level + 1);
    }
    return node;
}

}  // namespace rt
