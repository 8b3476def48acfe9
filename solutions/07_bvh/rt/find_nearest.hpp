#pragma once
#include <rt/search.hpp>

namespace rt {

// Tests one shape. If its hit is the nearest so far, remembers it in search.nearest and
// search.within.max. Of equally near shapes the one with the highest ID counts, as in
// SphereList, whatever order they come in.
template <class AnySearch>
void try_shape(int id, AnySearch& search) {
    const auto t = search.meets_shape(id);
    if (!t) return;
    // The interval ends at the nearest hit so far, so t is not larger. Before any hit, `nearest` is
    // -1, and no ID is less.
    if (*t == search.within.max && id < search.nearest) return;
    search.within.max = *t;
    search.nearest = id;
}

// Tests every shape below a node that may give a nearer hit than the nearest so far. The nearest
// child comes first: a hit in it makes the search in the others shorter.
template <class AnyNode, class AnySearch>
void find_nearest(const AnyNode& node, AnySearch& search) {
    if (node.is_leaf()) {
        for (const int id : search.shapes_in(node)) try_shape(id, search);
        return;
    }
    for (const auto& child : search.children_of(node))
        if (search.reaches(child)) find_nearest(child.node(), search);
}

}  // namespace rt
