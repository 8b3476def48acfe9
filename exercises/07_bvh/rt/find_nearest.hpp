#pragma once
#include <rt/search.hpp>
#include <rt/todo.hpp>
#include <rt/tree.hpp>

namespace rt {

// Exercise 07.4. Tests one sphere with search.meets_sphere(number), and remembers it in
// search.nearest and search.within.max if its hit is nearer than what was found so far. Of equally
// near spheres the one with the highest number counts, as in SphereList, in whatever order they
// come. The type is Search or another one with the same members: so it is written over types, as
// the path loop is.
template <class AnySearch>
void try_sphere(int number, AnySearch& search) {
    rt::todo("07.4", number, search);
}

// Exercise 07.4. Tries every sphere below a node that may be hit nearer than what was found so far.
// What lies in a box that the ray does not meet, by search.meets(box), is skipped; a leaf has a
// box, too. Each box is asked once, and before all that is below it: the right child only after the
// left one with all below it, as a hit there makes the search on the right shorter. A leaf has no
// children, and holds the spheres search.order[place] for place = first, first + 1, ... count of
// them. Trees have up to most_levels + 20 levels, and many threads search them at the same time.
template <class AnySearch>
void find_nearest(const TreeNode& node, AnySearch& search) {
    rt::todo("07.4", node, search);
}

}  // namespace rt
