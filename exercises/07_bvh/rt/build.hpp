#pragma once
#include <algorithm>
#include <memory>
#include <rt/bounds.hpp>
#include <rt/todo.hpp>
#include <rt/tree.hpp>
#include <span>

namespace rt {

// Both functions work on `order`, which is a part of the tree's order and holds the IDs of some
// spheres. boxes[id] is the box of the sphere with that ID, for all spheres of the scene. Ignore
// the boxes of spheres that are not in `order`. Move the IDs within `order`, and copy nothing.

// Exercise 07.3. Sorts all IDs in ascending order of the centers of their boxes, along the axis
// on which these centers are farthest apart; equal centers may be in any order. Returns how many of
// the IDs go to the left: half (rounded down), or 0 if there are at most leaf_size spheres,
// which need no split. Compare with <, never with <=.
inline int split_in_half(std::span<int> order, std::span<const Box> boxes) {
    return rt::todo("07.3", order, boxes);
}

// Exercise 07.3. The tree over this part of the order, which begins at index `first` of the whole
// order. The part has at least one ID. split(order, boxes), which is split_in_half or a
// function like it, returns how many of the IDs go to the left, or 0 for a leaf. Call split
// once for each node: it alone decides which nodes are leaves. The right part begins where the left
// part ends.
// Star: from level most_levels on, call split_in_half instead of split. The root is at level 0, and
// children are one level deeper than their parent.
template <class Split>
std::unique_ptr<TreeNode> build_node(std::span<int> order, int first, std::span<const Box> boxes,
                                     const Split& split, int level = 0) {
    return rt::todo("07.3", order, first, boxes, split, level);
}

}  // namespace rt
