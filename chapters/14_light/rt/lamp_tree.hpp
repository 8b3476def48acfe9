#pragma once
#include <algorithm>
#include <cstddef>
#include <limits>
#include <rt/build.hpp>
#include <rt/running_shares.hpp>
#include <span>
#include <vector>

namespace rt {

// A node of a tree of lamps (given).
struct LampNode {
    Box box;                 // around all lamps below
    Real power = 0;          // the sum of theirs, above 0
    int begin = 0, end = 0;  // they stand at these places of the tree's order, without the last
    int right = 0;           // the right child's index; the left child is the next node

    int lamps() const { return end - begin; }  // how many are below; a leaf has one
    bool is_leaf() const { return right == 0; }
};

// Many lamps in a tree (given), as the shapes of chapter 07. Lamps are told by their numbers, from
// 0 on. Dark ones are not in the tree.
struct LampTree {
    std::vector<LampNode> nodes;  // the root is the first; there is none if no lamp has any power
    std::vector<int> order;       // the lamps, leaf by leaf
    std::vector<int> places;      // for each lamp, its place in this order; -1: not in the tree
    std::vector<Real> shares;     // by power alone, from running_shares
};

// Appends the node over these lamps, which stand in the tree's order from `begin` on, and all nodes
// below it. Returns its index.
inline std::size_t add_lamps(LampTree& tree, std::span<int> lamps, int begin,
                             std::span<const Box> boxes, std::span<const Real> powers) {
    const std::size_t index = tree.nodes.size();
    const std::size_t count = lamps.size();
    tree.nodes.push_back({{}, 0, begin, begin + static_cast<int>(count), 0});
    LampNode node = tree.nodes[index];
    if (count == 1) {
        const auto lamp = static_cast<std::size_t>(lamps[0]);
        node.box = boxes[lamp];
        node.power = powers[lamp];
    } else {
        // split_in_half leaves groups of leaf_size together, which are halved as they are.
        auto half = static_cast<std::size_t>(split_in_half(lamps, boxes));
        if (half == 0) half = count / 2;
        const std::size_t left = add_lamps(tree, lamps.first(half), begin, boxes, powers);
        const std::size_t right =
            add_lamps(tree, lamps.subspan(half), begin + static_cast<int>(half), boxes, powers);
        node.right = static_cast<int>(right);
        node.box = join(tree.nodes[left].box, tree.nodes[right].box);
        node.power = tree.nodes[left].power + tree.nodes[right].power;
    }
    tree.nodes[index] = node;
    return index;
}

// The tree of these lamps, up to a million: boxes[i] is around lamp i, and powers[i], 0 or more,
// says how much light it sends out.
inline LampTree make_lamp_tree(std::span<const Box> boxes, const std::vector<Real>& powers) {
    LampTree tree;
    tree.shares = running_shares(powers);
    tree.places.assign(powers.size(), -1);
    // Only their ratios count. Divided by the largest, their sum does not overflow.
    Real largest = 0;
    for (const Real power : powers) largest = std::max(largest, power);
    std::vector<Real> ratios;
    for (std::size_t i = 0; i < powers.size(); ++i) {
        ratios.push_back(std::max(powers[i] / largest, std::numeric_limits<Real>::min()));
        if (powers[i] > 0) tree.order.push_back(static_cast<int>(i));
    }
    if (tree.order.empty()) return tree;
    tree.nodes.reserve(2 * tree.order.size());
    add_lamps(tree, tree.order, 0, boxes, ratios);
    for (std::size_t place = 0; place < tree.order.size(); ++place)
        tree.places[static_cast<std::size_t>(tree.order[place])] = static_cast<int>(place);
    return tree;
}

}  // namespace rt
