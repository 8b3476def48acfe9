#pragma once
#include <numeric>
#include <optional>
#include <rt/build.hpp>
#include <rt/hit_box.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/split_by_area.hpp>
#include <rt/surface_hit.hpp>
#include <rt/wide_tree.hpp>
#include <vector>

namespace rt {

// A sphere that moves along a line while the shutter is open (given).
struct MovingSphere {
    Sphere shape;  // at time 0
    Vec3 motion;   // how far it is from there at time 1
    int material = 0;
};

// Where it is at a time in [0, 1].
inline Sphere sphere_at(const MovingSphere& sphere, Real time) {
    return {sphere.shape.center + time * sphere.motion, sphere.shape.radius};
}

// A box that it does not leave.
inline Box bounds_of(const MovingSphere& sphere) {
    const Sphere end = sphere_at(sphere, 1);
    // Every place between is rounded twice; the bounds of spheres that are larger by that hold it.
    const Real larger =
        rounding_bound(4) * std::max(max_component(sphere.shape.center), max_component(end.center));
    return join(bounds_of(Sphere{sphere.shape.center, sphere.shape.radius + larger}),
                bounds_of(Sphere{end.center, end.radius + larger}));
}

// A tree of moving spheres: each lies in the box around all places where it will be.
struct MovingTree {
    std::vector<MovingSphere> spheres;
    std::vector<int> order;
    std::unique_ptr<TreeNode> root;  // none without spheres

    // The nearest hit at the ray's time.
    template <class TimedRay>
    std::optional<Hit> hit(const TimedRay& timed, Interval within) const {
        if (!root) return {};
        const Ray ray{timed.origin, timed.direction};
        const MovingSphere* nearest = nullptr;
        find(*root, ray, slab_ray(ray), timed.time, within, nearest);
        if (!nearest) return {};
        Hit hit = surface_hit(sphere_at(*nearest, timed.time), ray, within.max);
        hit.material = nearest->material;
        return hit;
    }

  private:
    void find(const TreeNode& node, const Ray& ray, const SlabRay& slabs, Real time,
              Interval& within, const MovingSphere*& nearest) const {
        if (!hit_box(node.box, slabs, with_origin(within))) return;
        if (!node.is_leaf()) {
            find(*node.left, ray, slabs, time, within, nearest);
            find(*node.right, ray, slabs, time, within, nearest);
            return;
        }
        for (int place = node.first; place < node.first + node.count; ++place) {
            const int number = order[static_cast<std::size_t>(place)];
            const MovingSphere& sphere = spheres[static_cast<std::size_t>(number)];
            const auto t = hit_sphere(sphere_at(sphere, time), ray, within);
            // Of equally near ones that with the highest number counts, as in SphereList.
            if (!t || (nearest && *t == within.max && &sphere < nearest)) continue;
            within.max = *t;
            nearest = &sphere;
        }
    }
};

inline MovingTree make_moving_tree(std::vector<MovingSphere> spheres) {
    MovingTree tree{std::move(spheres), {}, {}};
    std::vector<Box> boxes;
    for (const MovingSphere& sphere : tree.spheres) boxes.push_back(bounds_of(sphere));
    tree.order.resize(boxes.size());
    std::iota(tree.order.begin(), tree.order.end(), 0);
    if (!boxes.empty()) tree.root = build_node(std::span{tree.order}, 0, boxes, split_by_area);
    return tree;
}

// A world in which some spheres move and most stand still.
struct MovingWorld {
    WideTree still;
    MovingTree moving;

    template <class TimedRay>
    std::optional<Hit> hit(const TimedRay& ray, Interval within) const {
        const std::optional<Hit> standing = still.hit(ray, within);
        if (standing) within.max = standing->t;
        const std::optional<Hit> passing = moving.hit(ray, within);
        return passing ? passing : standing;
    }
};

}  // namespace rt
