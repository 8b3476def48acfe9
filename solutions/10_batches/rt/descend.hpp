#pragma once
#include <cstdint>
#include <rt/filter_list.hpp>
#include <rt/path_list.hpp>
#include <rt/wide_child.hpp>

namespace rt {

// Takes a list of rays down the tree, from a node that all of them meet. For each child, in the
// order of tree.order(node), the rays that meet the child's box form a new list. If the child is a
// leaf, tree.leaf gets this list, with the child's number; otherwise the list is taken farther
// down. The tree's functions:
//   tree.test(node, list, masks)   writes a mask for each ray of the list: bit k is set if the ray
//                                  meets the box of the child with index k. Returns the bits that
//                                  are set in any mask
//   tree.order(node)               the indices of the children, nearest first
//   tree.child(node, place)        the child with index `place`: another node, or a leaf
template <class Tree>
void descend(Tree& tree, std::int32_t node, PathList list, Scratch scratch) {
    const unsigned any = tree.test(node, list, scratch.masks);
    for (const unsigned place : tree.order(node)) {
        if (!(any >> place & 1)) continue;
        const std::size_t count = filter_list(list, scratch.masks, place, scratch.lists);
        const PathList part{scratch.lists, count};
        const Scratch rest{scratch.lists + count, scratch.masks + list.size()};
        const WideChild child = tree.child(node, place);
        if (child.is_leaf()) {
            tree.leaf(child.number(), part);
        } else {
            descend(tree, child.number(), part, rest);
        }
    }
}

}  // namespace rt
