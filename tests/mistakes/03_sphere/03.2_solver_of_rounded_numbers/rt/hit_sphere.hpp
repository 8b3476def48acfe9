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
    const Real a = dot(d, d), b = dot(f, d);
    const Real r_squared = sphere.radius * sphere.radius;
    if (!(a > 0)) return {};
    const Real c = dot(f, f) - r_squared;
    const auto roots = solve_quadratic(a, 2 * b, c);
    if (!roots) return {};
    if (within.contains(roots->low)) return roots->low;
    if (within.contains(roots->high)) return roots->high;
    return {};
}

}  // namespace rt
