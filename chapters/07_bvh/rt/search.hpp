#pragma once
#include <optional>
#include <rt/hit_box.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/sphere_list.hpp>
#include <span>

namespace rt {

// One ray on its way through a tree, and the nearest hit so far (given). Chapter 08 has searches of
// other types, which meet spheres that move or are stretched.
struct Search {
    std::span<const SceneSphere> spheres;  // of the scene
    std::span<const int> order;            // of the tree: its leaves hold indices into it
    Ray ray;
    Interval within;    // its upper end moves down to the nearest hit
    int nearest = -1;   // the number of the sphere that was hit there, -1 before any
    int box_tests = 0;  // how much work was done so far
    int sphere_tests = 0;
    SlabRay slabs = slab_ray(ray);

    // True if the ray meets a box where a hit would still count.
    bool meets(const Box& box) {
        ++box_tests;
        return hit_box(box, slabs, with_origin(within));
    }

    // The sphere with this number.
    const Sphere& sphere(int number) const {
        return spheres[static_cast<std::size_t>(number)].shape;
    }

    // Where the ray meets the sphere with this number within the interval.
    std::optional<Real> meets_sphere(int number) {
        ++sphere_tests;
        return hit_sphere(sphere(number), ray, within);
    }
};

}  // namespace rt
