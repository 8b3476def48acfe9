#pragma once
#include <optional>
#include <rt/hit_sphere.hpp>
#include <rt/interval.hpp>
#include <rt/nearest.hpp>
#include <rt/ray.hpp>
#include <rt/scene_sphere.hpp>
#include <span>

namespace rt {

// The sphere that the ray meets at the smallest t within the interval, and this t. If several
// spheres are equally near, the result is the last of them in the list. None if the ray meets no
// sphere within the interval.
inline std::optional<NearestSphere> nearest_sphere(std::span<const SceneSphere> spheres,
                                                   const Ray& ray, Interval within) {
    std::optional<NearestSphere> nearest;
    for (std::size_t i = 0; i < spheres.size(); ++i)
        if (const auto t = hit_sphere(spheres[i].shape, ray, within)) {
            nearest = NearestSphere{i, *t};
            within.max = *t;  // whatever is farther away no longer counts
        }
    return nearest;
}

}  // namespace rt
