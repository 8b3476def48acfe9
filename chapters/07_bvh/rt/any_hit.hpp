#pragma once
#include <rt/search.hpp>
#include <rt/tree.hpp>

namespace rt {

// True if the ray meets any shape below a node (given). That is all that a shadow ray needs to
// know, so the search ends at the first hit that it finds, which need not be the nearest.
template <class AnySearch>
bool meets_any(const TreeNode& node, AnySearch& search) {
    if (!search.meets(node.box)) return false;
    if (!node.is_leaf()) return meets_any(*node.left, search) || meets_any(*node.right, search);
    for (int place = node.first; place < node.first + node.count; ++place)
        if (search.meets_shape(search.order[static_cast<std::size_t>(place)])) return true;
    return false;
}

}  // namespace rt
