#pragma once
#include <optional>
#include <rt/dot.hpp>
#include <rt/interval.hpp>
#include <rt/quadratic.hpp>
#include <rt/ray.hpp>
#include <rt/sphere.hpp>

namespace rt {

inline std::optional<Real> hit_sphere(const Sphere& sphere, const Ray& ray, Interval within) {
    const Vec3 f = ray.origin - sphere.center;
    const Vec3 d = ray.direction;
    const auto roots =
        solve_quadratic(dot(d, d), 2 * dot(f, d), dot(f, f) - sphere.radius * sphere.radius);
    if (!roots) return {};
    if (within.contains(roots->low)) return roots->low;
    if (within.contains(roots->high)) return roots->high;
    return {};
}

}  // namespace rt
