#pragma once
#include <algorithm>
#include <rt/binned_split.hpp>
#include <rt/bounds.hpp>
#include <rt/shape_tree.hpp>
#include <rt/split_by_area.hpp>
#include <rt/wide_tree.hpp>
#include <vector>

namespace rt {

// Makes a WideTreeOf (given) from the binary tree of 07.3: each wide node replaces up to
// seven binary nodes.

// A shape's box, grown so that it still contains the shape after the box is rounded to Number and
// the slabs are computed in Number.
template <class Number, class Shape>
Box wide_bounds_of(const Shape& shape) {
    const Box box = bounds_of(shape);
    if (wide_margin<Number> <= hit_margin) return box;  // the box already includes hit_margin
    const Real grow =
        wide_margin<Number> * std::max(max_component(box.low), max_component(box.high));
    const Vec3 margin{grow, grow, grow};
    return {box.low - margin, box.high + margin};
}

// Changes a split so that it fills leaves of eight: eight shapes or fewer stay together, and if
// `split` finds nothing to gain, more than eight are halved in their present order.
template <class Split>
auto with_wide_leaves(const Split& split) {
    return [&split](std::span<int> order, std::span<const Box> boxes) {
        if (order.size() <= lanes) return 0;
        const int left = split(order, boxes);
        return left > 0 ? left : static_cast<int>(order.size() / 2);
    };
}

// Adds the wide leaf that holds the shapes of a binary leaf.
template <class Shape, class Number>
WideChild add_wide_leaf(WideTreeOf<Shape, Number>& wide, const TreeOf<Shape>& tree,
                        const TreeNode& leaf) {
    WideLeaf<Shape> shapes;
    for (int i = 0; i < leaf.count; ++i) {
        const int number = tree.order[static_cast<std::size_t>(leaf.first + i)];
        shapes.set(static_cast<std::size_t>(i), tree.shapes[static_cast<std::size_t>(number)],
                   number);
        wide.places[static_cast<std::size_t>(number)] =
            static_cast<std::uint32_t>(lanes * wide.leaves.size()) + static_cast<std::uint32_t>(i);
    }
    wide.leaves.push_back(shapes);
    return WideChild::leaf(static_cast<std::int32_t>(wide.leaves.size() - 1));
}

// Adds the wide node that replaces a binary node, and everything below it.
template <class Shape, class Number>
WideChild add_wide_node(WideTreeOf<Shape, Number>& wide, const TreeOf<Shape>& tree,
                        const TreeNode& top) {
    // Of the nodes in `parts`, the inner node with the largest box is met most often. Its two
    // children replace it, until there are eight nodes or all are leaves.
    std::vector<const TreeNode*> parts{&top};
    while (parts.size() < lanes) {
        const TreeNode** largest = nullptr;
        for (const TreeNode*& part : parts)
            if (!part->is_leaf() &&
                (!largest || surface_area(part->box) > surface_area((*largest)->box)))
                largest = &part;
        if (!largest) break;
        const TreeNode& split = **largest;
        *largest = split.left.get();
        parts.push_back(split.right.get());
    }

    const std::size_t place = wide.nodes.size();
    wide.nodes.emplace_back();
    WideNode<Number> node;  // not a reference: the list moves as it grows
    // Only a ray that is not finite, or whose origin is too large for Number, meets the empty box
    // of an unused lane. It then also tests the first leaf, which always exists; that is harmless.
    for (std::size_t i = 0; i < lanes; ++i) node.set(i, Box{}, WideChild::leaf(0));
    for (std::size_t i = 0; i < parts.size(); ++i)
        node.set(i, parts[i]->box,
                 parts[i]->is_leaf() ? add_wide_leaf(wide, tree, *parts[i])
                                     : add_wide_node(wide, tree, *parts[i]));
    wide.nodes[place] = node;
    return WideChild::node(static_cast<std::int32_t>(place));
}

// The tree with eight children per node, made from the binary tree of build_node with this split.
template <class Number, class Shape, class Split>
WideTreeOf<Shape, Number> make_wide_tree(const std::vector<Shape>& shapes, const Split& split) {
    std::vector<Box> boxes;
    boxes.reserve(shapes.size());
    for (const Shape& shape : shapes) boxes.push_back(wide_bounds_of<Number>(shape));
    const TreeOf<Shape> tree = make_tree(shapes, boxes, with_wide_leaves(split));
    WideTreeOf<Shape, Number> wide;
    wide.places.resize(shapes.size());
    if (tree.root) add_wide_node(wide, tree, *tree.root);
    wide.leaves.shrink_to_fit();
    wide.nodes.shrink_to_fit();
    return wide;
}

// The same with split_by_area for nodes just above the leaves and binned_split for all others. Bins
// need no sorting, which would take most of the time, and a search is hardly any slower for them.
template <class Number = float, class Shape>
WideTreeOf<Shape, Number> make_wide_tree(const std::vector<Shape>& shapes) {
    constexpr std::size_t most_sorted = 2 * lanes;
    return make_wide_tree<Number>(shapes, [](std::span<int> order, std::span<const Box> boxes) {
        return order.size() <= most_sorted ? split_by_area(order, boxes)
                                           : binned_split(order, boxes);
    });
}

}  // namespace rt
