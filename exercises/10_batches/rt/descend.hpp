#pragma once
#include <cstdint>
#include <rt/filter_list.hpp>
#include <rt/path_list.hpp>
#include <rt/todo.hpp>
#include <rt/wide_child.hpp>

namespace rt {

// Exercise 10.2. Takes the list of rays that meet a node, one ray or more, down the tree. For each
// child, the rays that meet the child's box form a list in the same order. Unless it is empty, this
// list goes on: to tree.leaf(the child's number, the list) if the child is a leaf, otherwise
// farther down. Visit the children in the order of tree.order(node), nearest first, and finish each
// child before you begin the next.
// Star: a node's list and masks must still be intact when its second child's turn comes, in chains
// of a hundred nodes and for lists of a hundred thousand rays. So put a child's list and masks
// behind the node's in the scratch memory, and pass on the memory behind them. The tree's
// functions:
//   tree.test(node, list, masks)   writes a mask for each ray of the list: bit k is set if the ray
//                                  meets the box of child number k. Returns the bits that any ray
//                                  has. Call it once for a node, when its turn comes: hits found
//                                  later shorten the rays, but an extra test costs little
//   tree.order(node)               the numbers of the children, 0 to 7, each once
//   tree.child(node, place)        child number `place`, a WideChild: child.is_leaf() tells whether
//                                  it is a leaf or a node, and child.number() which one
template <class Tree>
void descend(Tree& tree, std::int32_t node, PathList list, Scratch scratch) {
    rt::todo("10.2", tree, node, list, scratch);
}

}  // namespace rt
