#pragma once
#include <cstdint>
#include <rt/filter_list.hpp>
#include <rt/todo.hpp>

namespace rt {

// Room for what descend() writes down: a list, and its masks, for each level of nodes on the way
// down. None is longer than the first list.
struct Scratch {
    std::uint32_t* lists;
    std::uint8_t* masks;
};

// Exercise 10.2. Takes the list of rays that meet a node, one ray or more, down the tree: for each
// child whose box at least one of them meets, the list of those that do, in the same order, goes
// on: to tree.leaf(child, that list), or down. The children come in the order of tree.order(node),
// nearest first; a child is finished, with all below it, before the next one's turn.
//   tree.test(node, list, masks)   writes a mask for each ray of the list: bit k is set where it
//                                  meets the box of the child in place k. Returns the bits that any
//                                  ray has. Ask once for a node, when its turn has come: hits found
//                                  later shorten the rays, but a box too many costs little
//   tree.order(node)               the places of the children, 0 to 7, each once
//   tree.child(node, place)        that child: a node, 0 or higher, or a leaf, negative
// A node's list and masks must still stand when its second child's turn comes: so a child's list
// and masks go behind them in the scratch, and the way down gets the room behind those. Chains of a
// hundred nodes and lists of a hundred thousand rays are nothing special.
template <class Tree>
void descend(Tree& tree, std::int32_t node, PathList list, Scratch scratch) {
    rt::todo("10.2", tree, node, list, scratch);
}

}  // namespace rt
