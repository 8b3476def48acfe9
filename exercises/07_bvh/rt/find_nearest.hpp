#pragma once
#include <rt/search.hpp>
#include <rt/todo.hpp>
#include <rt/tree.hpp>

namespace rt {

// Exercise 07.4. Tests one shape, here a sphere, with search.meets_shape(number). If its hit is the
// nearest so far, remembers it in search.nearest and search.within.max. Of equally near shapes the
// one with the highest number counts, as in SphereList, whatever order they come in. AnySearch is
// Search or another type with the same members: the function is a template, like the path loop.
template <class AnySearch>
void try_shape(int number, AnySearch& search) {
    rt::todo("07.4", number, search);
}

// Exercise 07.4. Tests every shape below a node that may give a nearer hit than the nearest so far.
// If search.meets(box) says that the ray does not meet a box, skip everything in it. Test each box
// once, even the box of a leaf, before anything below it, and the right child's box only after
// everything below the left child. A leaf holds the shapes search.order[i] for the `count` indices
// i = first, first + 1, ...
// Star: trees have up to most_levels + 20 levels, and many threads search them at the same time.
template <class AnySearch>
void find_nearest(const TreeNode& node, AnySearch& search) {
    rt::todo("07.4", node, search);
}

}  // namespace rt
