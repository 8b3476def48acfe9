#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <rt/shape_tree.hpp>

namespace rt {

// A node of a tree in one array (given). The left child of node i is node i + 1; the right child
// comes after all nodes below the left one.
struct FlatNode {
    Box box;
    std::int32_t skip = 0;   // the first node that is not below this one
    std::int32_t first = 0;  // of a leaf: an index into the tree's order
    std::int32_t count = 0;  // 0 in an inner node
    std::int32_t axis =
        0;  // of an inner node: the axis along which the left child is the lower one
};

// The tree of TreeOf, with its nodes in one array instead of scattered over the heap (given).
template <class Shape>
struct FlatTreeOf {
    std::vector<Shape> shapes;
    std::vector<int> order;
    std::vector<FlatNode> nodes;

    // Visits the nodes in the order of the array. It needs no stack: if the ray misses a node, all
    // nodes below it are skipped, too.
    template <class AnyRay>
    SearchOf<Shape, AnyRay> search_in_order(const AnyRay& ray, Interval within) const {
        SearchOf<Shape, AnyRay> search{shapes, order, ray, within};
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

    // Of two children, visits first the one that the ray reaches first, judged by the ray's
    // direction alone. The search then finds near hits early, and can skip more boxes, because they
    // lie behind these hits. Waiting children are kept on a stack of a fixed size.
    template <class AnyRay>
    SearchOf<Shape, AnyRay> search_nearest_first(const AnyRay& ray, Interval within) const {
        SearchOf<Shape, AnyRay> search{shapes, order, ray, within};
        std::array<std::size_t, most_waiting> stack;
        std::size_t waiting = 0;
        if (!nodes.empty() && search.meets(nodes[0].box)) stack[waiting++] = 0;
        while (waiting > 0) {
            std::size_t i = stack[--waiting];
            bool met = true;
            while (met && nodes[i].count == 0) {
                const std::size_t left = i + 1, right = static_cast<std::size_t>(nodes[left].skip);
                const bool meets_left = search.meets(nodes[left].box);
                const bool meets_right = search.meets(nodes[right].box);
                const bool right_first = along(search.slabs.inverse, nodes[i].axis) < 0;
                if (meets_left && meets_right) stack[waiting++] = right_first ? left : right;
                i = meets_right && (right_first || !meets_left) ? right : left;
                met = meets_left || meets_right;
            }
            if (met) try_leaf(nodes[i], search);
        }
        return search;
    }

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        return hit_of(search_nearest_first(ray, within));
    }

  private:
    // At most one child waits for each inner node on the way down. From level most_levels on, each
    // step down halves the number of shapes.
    static constexpr std::size_t most_waiting =
        most_levels + halvings(std::numeric_limits<int>::max(), 1);

    template <class AnySearch>
    static void try_leaf(const FlatNode& node, AnySearch& search) {
        for (std::int32_t place = node.first; place < node.first + node.count; ++place)
            try_shape(search.order[static_cast<std::size_t>(place)], search);
    }
};
using FlatTree = FlatTreeOf<SceneSphere>;

// Appends a node and all nodes below it to an array.
inline void flatten(const TreeNode& node, std::vector<FlatNode>& nodes) {
    const std::size_t place = nodes.size();
    nodes.push_back({node.box, 0, node.first, node.count});
    if (!node.is_leaf()) {
        const Vec3 left = node.left->box.center(), right = node.right->box.center();
        const int axis = longest_axis(join({left, left}, {right, right}));
        const bool in_order = along(left, axis) <= along(right, axis);
        nodes[place].axis = axis;
        flatten(in_order ? *node.left : *node.right, nodes);
        flatten(in_order ? *node.right : *node.left, nodes);
    }
    nodes[place].skip = static_cast<std::int32_t>(nodes.size());
}

template <class Shape>
FlatTreeOf<Shape> make_flat(const TreeOf<Shape>& tree) {
    FlatTreeOf<Shape> flat{tree.shapes, tree.order, {}};
    if (tree.root) flatten(*tree.root, flat.nodes);
    return flat;
}

}  // namespace rt
