#pragma once
#include <algorithm>
#include <concepts>
#include <future>
#include <memory>
#include <numeric>
#include <rt/area_split.hpp>
#include <rt/binned_split.hpp>
#include <rt/bounds.hpp>
#include <rt/build.hpp>
#include <rt/wide_cut.hpp>
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
WideChild add_wide_leaf(WideTreeOf<Shape, Number>& wide, const std::vector<Shape>& all,
                        std::span<const int> order, const TreeNode& leaf) {
    WideLeaf<Shape> shapes;
    for (int i = 0; i < leaf.count; ++i) {
        const int number = order[static_cast<std::size_t>(leaf.first + i)];
        shapes.set(static_cast<std::size_t>(i), all[static_cast<std::size_t>(number)], number);
        wide.places[static_cast<std::size_t>(number)] =
            static_cast<std::uint32_t>(lanes * wide.leaves.size()) + static_cast<std::uint32_t>(i);
    }
    wide.leaves.push_back(shapes);
    return WideChild::leaf(static_cast<std::int32_t>(wide.leaves.size() - 1));
}

// Adds the wide node that replaces a binary node, and everything below it.
template <class Shape, class Number>
WideChild add_wide_node(WideTreeOf<Shape, Number>& wide, const std::vector<Shape>& all,
                        std::span<const int> order, const WideCut& cut, WideCut::Numbered top) {
    const auto children = cut.children(top);
    const std::size_t place = wide.nodes.size();
    wide.nodes.emplace_back();
    WideNode<Number> node;  // not a reference: the list moves as it grows
    // Only a ray that is not finite, or whose origin is too large for Number, meets the empty box
    // of an unused lane. It then also tests the first leaf, which always exists; that is harmless.
    for (std::size_t i = 0; i < lanes; ++i) node.set(i, Box{}, WideChild::leaf(0));
    for (std::size_t i = 0; i < children.size(); ++i) {
        const TreeNode& child = *children[i].node;
        node.set(i, child.box,
                 child.is_leaf() ? add_wide_leaf(wide, all, order, child)
                                 : add_wide_node(wide, all, order, cut, children[i]));
    }
    wide.nodes[place] = node;
    return WideChild::node(static_cast<std::int32_t>(place));
}

// The tree of build_node (07.3), built in several threads at once: this function makes the topmost
// nodes as build_node does, and gives each thread the part below one of them.
template <class Split>
std::unique_ptr<TreeNode> build_in_threads(std::span<int> order, int first,
                                           std::span<const Box> boxes, const Split& split,
                                           int threads, int level = 0) {
    constexpr std::size_t too_few = 10'000;  // to be worth a thread
#ifdef __EMSCRIPTEN__
    threads = 1;  // the browser gives none
#endif
    if (threads < 2 || order.size() < too_few || level == most_levels)
        return build_node(order, first, boxes, split, level);
    const int left = split(order, boxes);
    if (left == 0) return build_node(order, first, boxes, split, level);
    auto node = std::make_unique<TreeNode>();
    for (const int number : order)
        node->box = join(node->box, boxes[static_cast<std::size_t>(number)]);
    const auto cut = static_cast<std::size_t>(left);
    const auto share = static_cast<double>(threads) * left / static_cast<double>(order.size());
    const int on_left = std::clamp(static_cast<int>(share + 0.5), 1, threads - 1);
    auto left_node = std::async(std::launch::async, [&] {
        return build_in_threads(order.first(cut), first, boxes, split, on_left, level + 1);
    });
    node->right = build_in_threads(order.subspan(cut), first + left, boxes, split,
                                   threads - on_left, level + 1);
    node->left = left_node.get();
    return node;
}

inline std::size_t leaves_below(const TreeNode& node) {
    return node.is_leaf() ? 1 : leaves_below(*node.left) + leaves_below(*node.right);
}

// The tree with eight children per node, made from the binary tree of build_node with this split.
template <class Number, class Shape, std::invocable<std::span<int>, std::span<const Box>> Split>
WideTreeOf<Shape, Number> make_wide_tree(const std::vector<Shape>& shapes, const Split& split,
                                         int threads = 1) {
    if (shapes.empty()) return {};
    std::vector<Box> boxes;
    boxes.reserve(shapes.size());
    for (const Shape& shape : shapes) boxes.push_back(wide_bounds_of<Number>(shape));
    std::vector<int> order(shapes.size());
    std::iota(order.begin(), order.end(), 0);
    const auto root = build_in_threads(std::span{order}, 0, std::span<const Box>{boxes},
                                       with_wide_leaves(split), threads);
    boxes = {};  // a large tree needs the memory
    WideTreeOf<Shape, Number> wide;
    wide.places.resize(shapes.size());
    const std::size_t leaves = leaves_below(*root);
    wide.leaves.reserve(leaves);
    wide.nodes.reserve(leaves / 3 + 1);  // rarely more are needed
    add_wide_node(wide, shapes, order, WideCut{*root, leaves}, {root.get(), 0});
    return wide;
}

// The same with split_by_area for nodes just above the leaves and binned_split for all others. Bins
// need no sorting, which would take most of the time, and a search is hardly any slower for them.
// What the boxes cost hardly matters here: with_wide_leaves decides which shapes stay together.
template <class Number = float, class Shape>
WideTreeOf<Shape, Number> make_wide_tree(const std::vector<Shape>& shapes, int threads = 1) {
    constexpr std::size_t most_sorted = 2 * lanes;
    return make_wide_tree<Number>(
        shapes,
        [](std::span<int> order, std::span<const Box> boxes) {
            return order.size() <= most_sorted ? AreaSplit{1}(order, boxes)
                                               : binned_split(order, boxes);
        },
        threads);
}

}  // namespace rt
