#pragma once
#include <optional>
#include <rt/dot.hpp>
#include <rt/interval.hpp>
#include <rt/quadratic.hpp>
#include <rt/ray.hpp>
#include <rt/sphere.hpp>

namespace rt {

// The smallest t within the interval at which the ray meets the sphere's surface, from outside or
// from inside. None if the ray misses, and for a direction of length 0. Let d be the ray's
// direction, r the radius, f the vector from the center to the ray's origin, p the distance of the
// ray's line from the center, and h half the chord. The direction may have any length, as long as
// the squares of |d|, |f|, r, |f| |d| and r |d| neither overflow nor underflow. Then t |d| has an
// error of at most 6 epsilon (|f| + r) (1 + p / h), and hit or miss is decided correctly unless the
// line passes within 3 epsilon (|f| + r) of the sphere's rim. docs/03-sphere.md derives the formula
// and both bounds.
inline std::optional<Real> hit_sphere(const Sphere& sphere, const Ray& ray, Interval within) {
    // Points at distance r from the center: a t^2 + b t + c = 0.
    const Vec3 f = ray.origin - sphere.center;
    const Vec3 d = ray.direction;
    const Real a = dot(d, d), b = 2 * dot(f, d);
    const Real r_squared = sphere.radius * sphere.radius;

    // b^2 - 4 a c would cancel if the sphere is far away or small. A quarter of it is
    // a r^2 - |f x d|^2, whose terms are small for a ray near the sphere. cross() of chapter 01
    // would also do, but its extra digits cost time and are of no use, because f is rounded
    // already.
    const Vec3 moment{f.y * d.z - f.z * d.y, f.z * d.x - f.x * d.z, f.x * d.y - f.y * d.x};
    const Real quarter = a * r_squared - dot(moment, moment);
    if (!(a > 0 && quarter >= 0)) return {};  // most rays miss: they are done here

    const Real c = dot(f, f) - r_squared;
    const auto roots = roots_from_discriminant(a, b, c, 4 * quarter);
    if (!roots) return {};
    if (within.contains(roots->low)) return roots->low;
    if (within.contains(roots->high)) return roots->high;
    return {};
}

}  // namespace rt
