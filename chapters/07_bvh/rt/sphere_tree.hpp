#pragma once
#include <memory>
#include <numeric>
#include <optional>
#include <rt/build.hpp>
#include <rt/find_nearest.hpp>
#include <rt/sphere_list.hpp>
#include <vector>

namespace rt {

// Makes the Hit for the sphere that a search has found, as SphereList does.
template <class AnySearch>
std::optional<Hit> hit_of(const AnySearch& search) {
    if (search.nearest < 0) return {};
    Hit hit = surface_hit(search.sphere(search.nearest), search.ray, search.within.max);
    hit.material = search.spheres[static_cast<std::size_t>(search.nearest)].material;
    return hit;
}

inline std::vector<Box> bounds_of(const std::vector<SceneSphere>& spheres) {
    std::vector<Box> boxes;
    boxes.reserve(spheres.size());
    for (const SceneSphere& sphere : spheres) boxes.push_back(bounds_of(sphere.shape));
    return boxes;
}

// A world of spheres in a tree of boxes (given). It gives the hits of SphereList, bit for bit.
struct SphereTree {
    std::vector<SceneSphere> spheres;
    std::vector<int> order;          // the numbers of the spheres, leaf by leaf
    std::unique_ptr<TreeNode> root;  // null without spheres

    // The search of a ray through the tree.
    template <class AnyRay>
    Search search(const AnyRay& ray, Interval within) const {
        Search search{spheres, order, {ray.origin, ray.direction}, within};
        if (root) find_nearest(*root, search);
        return search;
    }

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        return hit_of(search(ray, within));
    }
};

// boxes[i] is the box of sphere i; split is split_in_half, split_by_area or another function like
// them.
template <class Split>
SphereTree make_tree(std::vector<SceneSphere> spheres, const std::vector<Box>& boxes,
                     const Split& split) {
    SphereTree tree{std::move(spheres), {}, nullptr};
    tree.order.resize(tree.spheres.size());
    std::iota(tree.order.begin(), tree.order.end(), 0);
    if (!tree.order.empty())
        tree.root = build_node(std::span{tree.order}, 0, std::span{boxes}, split);
    return tree;
}
template <class Split>
SphereTree make_tree(std::vector<SceneSphere> spheres, const Split& split) {
    const std::vector<Box> boxes = bounds_of(spheres);
    return make_tree(std::move(spheres), boxes, split);
}

}  // namespace rt
