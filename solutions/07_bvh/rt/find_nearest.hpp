#pragma once
#include <rt/search.hpp>
#include <rt/tree.hpp>

namespace rt {

// Tests one sphere, and remembers it in search.nearest and search.within.max if its hit is nearer
// than what was found so far. Of equally near spheres the one with the highest number counts, as in
// SphereList, in whatever order they come.
template <class AnySearch>
void try_sphere(int number, AnySearch& search) {
    const auto t = search.meets_sphere(number);
    if (!t) return;
    // The interval's end is where the nearest hit so far is: t is at most as large.
    if (search.nearest >= 0 && *t == search.within.max && number < search.nearest) return;
    search.within.max = *t;
    search.nearest = number;
}

// Tries every sphere below a node that may be hit nearer than what was found so far. What lies in a
// box that the ray does not meet is skipped.
template <class AnySearch>
void find_nearest(const TreeNode& node, AnySearch& search) {
    if (!search.meets(node.box)) return;
    if (node.is_leaf()) {
        for (int place = node.first; place < node.first + node.count; ++place)
            try_sphere(search.order[static_cast<std::size_t>(place)], search);
        return;
    }
    find_nearest(*node.left, search);
    find_nearest(*node.right, search);
}

}  // namespace rt
