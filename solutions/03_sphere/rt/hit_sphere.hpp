#pragma once
#include <optional>
#include <rt/dot.hpp>
#include <rt/interval.hpp>
#include <rt/quadratic.hpp>
#include <rt/ray.hpp>
#include <rt/sphere.hpp>

namespace rt {

// The smallest t within the interval at which the ray meets the sphere's surface, from outside or
// from inside. None where it passes by, and for a direction of length 0.
// Source of the discriminant: Haines, Gunther and Akenine-Moller, "Precision improvements for
// ray/sphere intersection", Ray Tracing Gems, chapter 7, 2019.
inline std::optional<Real> hit_sphere(const Sphere& sphere, const Ray& ray, Interval within) {
    const Vec3 f = ray.origin - sphere.center;
    const Vec3 d = ray.direction;
    // Points at distance r from the center: a t^2 + 2 b t + c = 0.
    const Real a = dot(d, d);
    const Real b = dot(f, d);
    const Real c = dot(f, f) - sphere.radius * sphere.radius;
    if (!(a > 0)) return {};

    // b^2 - a c cancels when the sphere is far or small. With the vector from the center to the
    // nearest point of the line it is a (r^2 - |nearest|^2), whose terms are as small as the
    // sphere.
    const Vec3 nearest = f - (b / a) * d;
    const Real quarter = a * (sphere.radius * sphere.radius - dot(nearest, nearest));

    const auto roots = roots_from_discriminant(a, 2 * b, c, 4 * quarter);
    if (!roots) return {};
    if (within.contains(roots->low)) return roots->low;
    if (within.contains(roots->high)) return roots->high;
    return {};
}

}  // namespace rt
