#pragma once
#include <optional>
#include <rt/bounds.hpp>
#include <rt/sphere_tree.hpp>
#include <rt/split_by_area.hpp>
#include <rt/two_worlds.hpp>
#include <rt/wide_tree.hpp>
#include <span>
#include <vector>

namespace rt {

// A sphere that moves along a line while the shutter is open (given).
struct MovingSphere {
    Sphere shape;  // at time 0
    Vec3 motion;   // how far it has moved from there at time 1
    int material = 0;
};

// The sphere at a time in [0, 1].
inline Sphere sphere_at(const MovingSphere& sphere, Real time) {
    return moved(sphere.shape, time * sphere.motion);
}

// A box that the sphere never leaves.
inline Box bounds_of(const MovingSphere& sphere) {
    const Sphere end = sphere_at(sphere, 1);
    // Every position in between is rounded twice; the bounds of spheres that are larger by
    // that contain it.
    const Real larger =
        rounding_bound(4) * std::max(max_component(sphere.shape.center), max_component(end.center));
    return join(bounds_of(Sphere{sphere.shape.center, sphere.shape.radius + larger}),
                bounds_of(Sphere{end.center, end.radius + larger}));
}

// A search among spheres, each where it is at the ray's time.
struct MovingSearch : Search {
    std::span<const Vec3> motions;
    Real time = 0;

    Sphere sphere(int number) const {
        const auto i = static_cast<std::size_t>(number);
        return moved(spheres[i].shape, time * motions[i]);
    }
    std::optional<Real> meets_sphere(int number) {
        ++sphere_tests;
        return hit_sphere(sphere(number), ray, within);
    }
};

// A tree of moving spheres: each is in the box around all its positions.
struct MovingTree {
    SphereTree tree;
    std::vector<Vec3> motions;

    // The nearest hit at the ray's time.
    template <class TimedRay>
    std::optional<Hit> hit(const TimedRay& timed, Interval within) const {
        if (!tree.root) return {};
        MovingSearch search{{tree.spheres, tree.order, {timed.origin, timed.direction}, within},
                            motions,
                            timed.time};
        find_nearest(*tree.root, search);
        return hit_of(search);
    }
};

inline MovingTree make_moving_tree(const std::vector<MovingSphere>& spheres) {
    std::vector<SceneSphere> at_start;
    std::vector<Box> boxes;
    std::vector<Vec3> motions;
    for (const MovingSphere& sphere : spheres) {
        at_start.push_back({sphere.shape, sphere.material});
        boxes.push_back(bounds_of(sphere));
        motions.push_back(sphere.motion);
    }
    return {make_tree(std::move(at_start), boxes, split_by_area), std::move(motions)};
}

// A world in which some spheres move and most stand still.
using MovingWorld = TwoWorlds<WideTree, MovingTree>;

}  // namespace rt
