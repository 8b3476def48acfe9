#pragma once
#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <rt/build.hpp>
#include <rt/find_nearest.hpp>
#include <rt/instance.hpp>
#include <rt/split_by_area.hpp>
#include <span>
#include <vector>

namespace rt {

// A search among instances (given).
struct InstanceSearch : Search {
    std::span<const Instance> instances;

    std::optional<Real> meets_sphere(int number) {
        ++sphere_tests;
        return hit_instance(instances[static_cast<std::size_t>(number)], ray, within);
    }
};

// A world of instances in a tree of boxes, built and searched like the tree of spheres (given).
struct InstanceTree {
    std::vector<Instance> instances;
    std::vector<int> order;          // the numbers of the instances, leaf by leaf
    std::unique_ptr<TreeNode> root;  // null without instances
    Real factor = 1;                 // the largest margin_factor: it applies to the ray, too

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& any_ray, Interval within) const {
        if (!root) return {};
        InstanceSearch search{{{}, order, {any_ray.origin, any_ray.direction}, within}, instances};
        search.slabs.margin *= factor;
        find_nearest(*root, search);
        if (search.nearest < 0) return {};
        return surface_hit(instances[static_cast<std::size_t>(search.nearest)], search.ray,
                           search.within.max);
    }
};

inline InstanceTree make_instance_tree(std::vector<Instance> instances) {
    InstanceTree tree{std::move(instances), {}, nullptr};
    std::vector<Box> boxes;
    for (const Instance& instance : tree.instances) {
        boxes.push_back(bounds_of(instance));
        tree.factor = std::max(tree.factor, margin_factor(instance));
    }
    tree.order.resize(boxes.size());
    std::iota(tree.order.begin(), tree.order.end(), 0);
    if (!boxes.empty())
        tree.root =
            build_node(std::span{tree.order}, 0, std::span<const Box>{boxes}, split_by_area);
    return tree;
}

}  // namespace rt
