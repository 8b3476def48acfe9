#pragma once
#include <rt/search.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 07.4. Tests one shape, here a sphere, with search.meets_shape(id). If its hit is the
// nearest so far, remembers it in search.nearest and search.within.max. Of equally near shapes the
// one with the highest ID counts, as in SphereList, whatever order they come in.
template <class AnySearch>
void try_shape(int id, AnySearch& search) {
    rt::todo("07.4", id, search);
}

// Exercise 07.4. Tests every shape below a node that may give a nearer hit than the nearest so far.
// Of a leaf, these are search.shapes_in(node). Of another node, search.children_of(node) has the
// children whose boxes the ray meets, the nearest first. Search each child.node() in this order, if
// search.reaches(child) is true just before: a hit in one child may lie in front of the next.
// AnyNode is a node of your tree, with two children, or of another tree, with eight.
// Star: trees have up to most_levels + 20 levels, and many threads search them at the same time. If
// the function calls itself and changes nothing but `search`, there is nothing to add.
template <class AnyNode, class AnySearch>
void find_nearest(const AnyNode& node, AnySearch& search) {
    rt::todo("07.4", node, search);
}

}  // namespace rt
