#pragma once
#include <cstdint>
#include <rt/filter_list.hpp>
#include <rt/path_list.hpp>
#include <rt/wide_child.hpp>

namespace rt {

// Takes a list of rays, which all meet a node, down the tree. For each child, in the order of
// tree.order(node), which is nearest first for these rays, the rays that meet the child's box form
// a list. If the child is a leaf, tree.leaf(its number, list) gets this list; otherwise the list is
// taken farther down.
//   tree.test(node, list, masks)   tells which children's boxes each ray meets, one bit each, and
//                                  returns the bits that any of the rays has
//   tree.order(node)               the children's numbers, nearest first
//   tree.child(node, place)        child number `place`: another node, or a leaf
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
