#pragma once
#include <algorithm>
#include <memory>
#include <rt/bounds.hpp>
#include <rt/todo.hpp>
#include <rt/tree.hpp>
#include <span>

namespace rt {

// Both functions work on a part of the tree's order: the numbers of some spheres. boxes belongs to
// the whole scene: boxes[number] is the box of the sphere with that number, and only those whose
// numbers are in order count. Move the numbers within order, and copy nothing.

// Exercise 07.3. Sorts the numbers, all of them, in ascending order of the middles of their boxes,
// along the axis on which these middles are farthest apart; equal ones may be in any order. Returns
// how many of them go to the left: half (rounded down), or 0 if there are only leaf_size or fewer,
// which need no split. Compare with <, never with <=.
inline int split_in_half(std::span<int> order, std::span<const Box> boxes) {
    return rt::todo("07.3", order, boxes);
}

// Exercise 07.3. The tree over this part of the order, which begins at index `first` of the whole
// order. It must have at least one number. split(order, boxes) is split_in_half or another function
// like it, and returns how many of the numbers go to the left, 0 for a leaf. Call it once for each
// node: nothing else decides which nodes are leaves. The right part begins where the left one ends.
// Star: from level most_levels on, call split_in_half instead of split. The root is at level 0, and
// children are one level deeper than their parent.
template <class Split>
std::unique_ptr<TreeNode> build_node(std::span<int> order, int first, std::span<const Box> boxes,
                                     const Split& split, int level = 0) {
    return rt::todo("07.3", order, first, boxes, split, level);
}

}  // namespace rt
