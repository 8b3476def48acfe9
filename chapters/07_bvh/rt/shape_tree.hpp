#pragma once
#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <rt/any_hit.hpp>
#include <rt/build.hpp>
#include <rt/find_nearest.hpp>
#include <vector>

namespace rt {

template <class Shape>
std::vector<Box> bounds_of(const std::vector<Shape>& shapes) {
    std::vector<Box> boxes;
    boxes.reserve(shapes.size());
    for (const Shape& shape : shapes) boxes.push_back(bounds_of(shape));
    return boxes;
}

// The margin of the boxes around a shape, in multiples of the usual margin. Long ellipsoids need
// more than 1.
template <class Shape>
Real margin_factor(const Shape&) {
    return 1;
}

// A world of shapes in a tree of boxes (given). It finds the same hits as a list, bit for bit.
template <class Shape>
struct TreeOf {
    std::vector<Shape> shapes;
    std::vector<int> order;          // the IDs of the shapes, leaf by leaf
    std::unique_ptr<TreeNode> root;  // null without shapes
    Real factor = 1;                 // the largest margin_factor: it applies to the ray, too

    // Searches the tree along a ray.
    template <class AnyRay>
    SearchOf<Shape, AnyRay> search(const AnyRay& ray, Interval within) const {
        auto search = search_before_start(ray, within);
        run(search);
        return search;
    }

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        return hit_of(search(ray, within));
    }

    // True if anything is hit within the interval.
    template <class AnyRay>
    bool occluded(const AnyRay& ray, Interval within) const {
        AnyHit search{search_before_start(ray, within)};
        run(search);
        return search.found();
    }

  private:
    template <class AnyRay>
    SearchOf<Shape, AnyRay> search_before_start(const AnyRay& ray, Interval within) const {
        SearchOf<Shape, AnyRay> search{shapes, order, ray, within};
        search.slabs.margin *= factor;
        return search;
    }
    template <class AnySearch>
    void run(AnySearch& search) const {
        if (root && search.meets(root->box)) find_nearest(*root, search);
    }
};
using SphereTree = TreeOf<SceneSphere>;

// The tree over these shapes. boxes[i] is the box of shape i; split is split_in_half, an
// AreaSplit or a function like them.
template <class Shape, class Split>
TreeOf<Shape> make_tree(std::vector<Shape> shapes, const std::vector<Box>& boxes,
                        const Split& split) {
    TreeOf<Shape> tree{std::move(shapes), {}, nullptr};
    for (const Shape& shape : tree.shapes)
        tree.factor = std::max(tree.factor, margin_factor(shape));
    tree.order.resize(tree.shapes.size());
    std::iota(tree.order.begin(), tree.order.end(), 0);
    if (!tree.order.empty())
        tree.root = build_node(std::span{tree.order}, 0, std::span{boxes}, split);
    return tree;
}
template <class Shape, class Split>
TreeOf<Shape> make_tree(std::vector<Shape> shapes, const Split& split) {
    const std::vector<Box> boxes = bounds_of(shapes);
    return make_tree(std::move(shapes), boxes, split);
}

}  // namespace rt
