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
    const Real a = dot(ray.direction, ray.direction);
    const Real b = dot(f, ray.direction);
    const Real c = dot(f, f) - sphere.radius * sphere.radius;
    const Real quarter = b * b - a * c;
    if (quarter < 0) return {};
    const auto roots = roots_from_discriminant(a, 2 * b, c, 4 * quarter);
    if (!roots) return {};
    if (within.contains(roots->low)) return roots->low;
    if (within.contains(roots->high)) return roots->high;
    return {};
}
}  // namespace rt
