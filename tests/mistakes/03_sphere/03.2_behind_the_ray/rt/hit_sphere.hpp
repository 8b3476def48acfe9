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
    const Vec3 moment{f.y * d.z - f.z * d.y, f.z * d.x - f.x * d.z, f.x * d.y - f.y * d.x};
    const Real quarter = a * r_squared - dot(moment, moment);
    if (!(a > 0 && quarter >= 0)) return {};
    const Real c = dot(f, f) - r_squared;
    const auto roots = roots_from_discriminant(a, 2 * b, c, 4 * quarter);
    if (!roots) return {};
    if (roots->low <= within.max) return roots->low;
    return {};
}

}  // namespace rt
