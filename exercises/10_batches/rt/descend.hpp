#pragma once
#include <cstdint>
#include <rt/filter_list.hpp>
#include <rt/path_list.hpp>
#include <rt/todo.hpp>
#include <rt/wide_child.hpp>

namespace rt {

// Exercise 10.2. Takes a list of rays down the tree, from a node that all of them meet. The list
// has at least one ray. For each child, the rays that meet the child's box form a new list, in the
// same order. Skip a child with an empty list. Pass the list of a leaf to tree.leaf, with the
// leaf's number, and take the list of a node down the tree in the same way. Visit the children in
// the order of tree.order(node), nearest first, and finish each child before you begin the next.
// Star: a node's list and masks must still be intact when its second child's turn comes, in chains
// of a hundred nodes and for lists of a hundred thousand rays. So write a child's list at the
// beginning of scratch.lists, and the node's masks at the beginning of scratch.masks, and pass on
// only the memory after them. The tree's functions:
//   tree.test(node, list, masks)   writes a mask for each ray of the list: bit k is set if the ray
//                                  meets the box of the child with index k. Returns the bits that
//                                  are set in any mask. Call it once for a node, when the node's
//                                  turn comes: hits found later shorten the rays, but an
//                                  unnecessary visit costs little
//   tree.order(node)               the indices of the children, 0 to 7, each once
//   tree.child(node, place)        the child with index `place`, a WideChild: child.is_leaf() tells
//                                  whether it is a leaf or a node, and child.number() which one
template <class Tree>
void descend(Tree& tree, std::int32_t node, PathList list, Scratch scratch) {
    rt::todo("10.2", tree, node, list, scratch);
}

}  // namespace rt
