#pragma once
#include <optional>
#include <rt/hit_box.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/sphere_list.hpp>
#include <span>

namespace rt {

// One ray on its way through a tree, and the nearest hit so far (given).
struct Search {
    std::span<const SceneSphere> spheres;  // of the scene
    std::span<const int> order;            // of the tree: its leaves hold places in it
    Ray ray;
    Interval within;    // its upper end moves down to the nearest hit
    int nearest = -1;   // the number of the sphere that was hit there, -1 before any
    int box_tests = 0;  // how much work it was so far
    int sphere_tests = 0;
    SlabRay slabs = slab_ray(ray);
    // Where spheres move (chapter 08), how far each is at time 1 from where it is at time 0; none
    // where they all stand still.
    std::span<const Vec3> motions = {};
    Real time = 0;  // of the ray

    // Whether the ray meets a box where a hit would still count.
    bool meets(const Box& box) {
        ++box_tests;
        return hit_box(box, slabs, with_origin(within));
    }

    // The sphere of this number, where it is at the ray's time.
    Sphere sphere(int number) const {
        const auto i = static_cast<std::size_t>(number);
        return motions.empty() ? spheres[i].shape : moved(spheres[i].shape, time * motions[i]);
    }

    // Where the ray meets the sphere of this number within the interval.
    std::optional<Real> meets_sphere(int number) {
        ++sphere_tests;
        return hit_sphere(sphere(number), ray, within);
    }
};

}  // namespace rt
