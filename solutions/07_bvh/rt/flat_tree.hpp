#pragma once
#include <array>
#include <cstdint>
#include <rt/sphere_tree.hpp>

namespace rt {

// A node of a tree in one array (given). The left child of node i is node i + 1.
struct FlatNode {
    Box box;
    std::int32_t skip = 0;   // the first node that is not below this one
    std::int32_t first = 0;  // of a leaf: places in the tree's order
    std::int32_t count = 0;  // 0 in an inner node
};

// The tree of SphereTree, its nodes in one array instead of scattered over the heap (given).
struct FlatTree {
    std::vector<SceneSphere> spheres;
    std::vector<int> order;
    std::vector<FlatNode> nodes;

    // In the order of the array. No stack: a node that is missed is skipped with all below it.
    template <class AnyRay>
    Search search_in_order(const AnyRay& ray, Interval within) const {
        Search search{spheres, order, {ray.origin, ray.direction}, within};
        for (std::size_t i = 0; i < nodes.size();) {
            const FlatNode& node = nodes[i];
            if (!search.meets(node.box)) {
                i = static_cast<std::size_t>(node.skip);
                continue;
            }
            try_leaf(node, search);
            ++i;
        }
        return search;
    }

    // The child whose box begins nearer first: hits are found earlier, and more boxes lie behind
    // them. What waits is kept on a stack of a fixed size.
    template <class AnyRay>
    Search search_nearest_first(const AnyRay& ray, Interval within) const {
        Search search{spheres, order, {ray.origin, ray.direction}, within};
        if (nodes.empty() || !search.meets(nodes[0].box)) return search;
        struct Waiting {
            std::size_t node;
            Real enters;
        };
        std::array<Waiting, 2 * most_levels> stack;
        std::size_t waiting = 0, i = 0;
        for (;;) {
            const FlatNode& node = nodes[i];
            bool down = false;
            if (node.count > 0) {
                try_leaf(node, search);
            } else {
                search.box_tests += 2;
                const std::size_t left = i + 1, right = static_cast<std::size_t>(nodes[left].skip);
                const Real to_left = enters(nodes[left].box, search);
                const Real to_right = enters(nodes[right].box, search);
                const bool left_first = to_left <= to_right;
                const Real near = left_first ? to_left : to_right;
                const Real far = left_first ? to_right : to_left;
                if (far < infinity) stack[waiting++] = {left_first ? right : left, far};
                if (near < infinity) {
                    i = left_first ? left : right;
                    down = true;
                }
            }
            while (!down) {
                if (waiting == 0) return search;
                const Waiting next = stack[--waiting];
                // Meanwhile a hit may have been found in front of it.
                if (next.enters > with_origin(search.within).max) continue;
                i = next.node;
                down = true;
            }
        }
    }

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        return hit_of(search_nearest_first(ray, within));
    }

  private:
    static void try_leaf(const FlatNode& node, Search& search) {
        for (std::int32_t place = node.first; place < node.first + node.count; ++place)
            try_sphere(search.order[static_cast<std::size_t>(place)], search);
    }

    // The t at which the search enters a box; infinity where it does not.
    static Real enters(const Box& box, const Search& search) {
        const SlabRay& ray = search.slabs;
        Interval within = with_origin(search.within);
        for (int axis = 0; axis < 3; ++axis) {
            const Real inverse = along(ray.inverse, axis), origin = along(ray.origin, axis);
            const Real low = along(box.low, axis) - ray.margin;
            const Real high = along(box.high, axis) + ray.margin;
            const bool forward = !std::signbit(inverse);
            within.min = std::max(within.min, ((forward ? low : high) - origin) * inverse);
            within.max = std::min(within.max, ((forward ? high : low) - origin) * inverse);
        }
        // Beyond the largest number there are no hits, so infinity is free to mean a miss.
        return within.min <= within.max ? within.min : infinity;
    }
};

// Puts the nodes below one, and itself, at the end of an array.
inline void flatten(const TreeNode& node, std::vector<FlatNode>& nodes) {
    const std::size_t place = nodes.size();
    nodes.push_back({node.box, 0, node.first, node.count});
    if (!node.is_leaf()) {
        flatten(*node.left, nodes);
        flatten(*node.right, nodes);
    }
    nodes[place].skip = static_cast<std::int32_t>(nodes.size());
}

inline FlatTree make_flat(const SphereTree& tree) {
    FlatTree flat{tree.spheres, tree.order, {}};
    if (tree.root) flatten(*tree.root, flat.nodes);
    return flat;
}

}  // namespace rt
