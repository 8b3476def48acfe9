#pragma once
#define nearest_sphere nearest_sphere_unrecorded
#include_next <rt/nearest_sphere.hpp>
#undef nearest_sphere
#include <rt/record.hpp>

namespace rt {

inline std::optional<NearestSphere> nearest_sphere(std::span<const SceneSphere> spheres,
                                                   const Ray& ray, Interval within) {
    static std::once_flag once;
    std::call_once(once, [&] { recorder::note_spheres(spheres, [](const auto&...) {}); });
    return nearest_sphere_unrecorded(spheres, ray, within);
}

}  // namespace rt
