#pragma once
#pragma GCC system_header  // #include_next is no part of the standard
#define nearest_sphere nearest_sphere_unfollowed
#include_next <rt/nearest_sphere.hpp>
#undef nearest_sphere
#include <rt/trail.hpp>

namespace rt {

inline std::optional<NearestSphere> nearest_sphere(std::span<const SceneSphere> spheres,
                                                   const Ray& ray, Interval within) {
    const auto nearest = nearest_sphere_unfollowed(spheres, ray, within);
    if (!follow::here.in_sample || follow::here.in_path) return nearest;
    if (follow::here.segments++ > 0)
        follow::trail().step("ray", "origin", ray.origin, "direction", ray.direction);
    if (!nearest) {
        follow::trail().step("miss");
    } else {
        const Sphere& sphere = spheres[nearest->number].shape;
        follow::trail().step("hit", "t", nearest->t, "point", ray.at(nearest->t), "number",
                             nearest->number, "center", sphere.center, "radius", sphere.radius);
    }
    return nearest;
}

}  // namespace rt
