#pragma once
#include <cstdint>
#include <rt/filter_list.hpp>
#include <rt/todo.hpp>

namespace rt {

// Room for what descend() writes down: as many lists and masks as a way down the tree can need.
struct Scratch {
    std::uint32_t* lists;
    std::uint8_t* masks;
};

// Exercise 10.2. Takes the list of rays that meet a node down the tree: for each child whose box at
// least one of them meets, the list of those that do goes on, to tree.leaf(child, that list) or
// down. The children come in the order of tree.order(node), nearest first.
//   tree.test(node, list, masks)   writes a mask for each ray of the list: bit k is set where it
//                                  meets the box of the child in place k. Returns the bits that any
//                                  ray has. Ask once for a node: hits found later shorten the rays,
//                                  but a box too many costs little
//   tree.order(node)               the places of the children, each once
//   tree.child(node, place)        that child: a node, or, where it is negative, a leaf
// The list that came in, and its masks, must still stand when the second child's turn comes: so the
// next list and its masks go behind them in the scratch, and the way down gets what is left.
template <class Tree>
void descend(Tree& tree, std::int32_t node, PathList list, Scratch scratch) {
    rt::todo("10.2", tree, node, list, scratch);
}

}  // namespace rt
