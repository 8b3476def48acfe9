#pragma once
#include <rt/search.hpp>
#include <rt/tree.hpp>

namespace rt {

// Tests one shape. If its hit is the nearest so far, remembers it in search.nearest and
// search.within.max. Of equally near shapes the one with the highest number counts, as in
// SphereList, whatever order they come in.
template <class AnySearch>
void try_shape(int number, AnySearch& search) {
    const auto t = search.meets_shape(number);
    if (!t) return;
    // The interval ends at the nearest hit so far, so t is not larger.
    if (search.nearest >= 0 && *t == search.within.max && number < search.nearest) return;
    search.within.max = *t;
    search.nearest = number;
}

// Tests every shape below a node that may give a nearer hit than the nearest so far. If the ray
// does not meet a box, everything in it is skipped.
template <class AnySearch>
void find_nearest(const TreeNode& node, AnySearch& search) {
    if (!search.meets(node.box)) return;
    if (node.is_leaf()) {
        for (int place = node.first; place < node.first + node.count; ++place)
            try_shape(search.order[static_cast<std::size_t>(place)], search);
        return;
    }
    find_nearest(*node.left, search);
    find_nearest(*node.right, search);
}

}  // namespace rt
