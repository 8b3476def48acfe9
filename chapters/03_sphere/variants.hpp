#pragma once
// Other ways to intersect a sphere: the chapter's picture and its study show what each is worth.

#include <optional>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/hit_sphere.hpp>

namespace variants {

using rt::Interval, rt::Ray, rt::Real, rt::Roots, rt::Sphere, rt::Vec3;

// Any function that finds the nearest hit, as rt::hit_sphere does.
using HitFunction = std::optional<Real> (*)(const Sphere&, const Ray&, Interval);

inline std::optional<Real> nearest_within(const std::optional<Roots>& roots, Interval within) {
    if (!roots) return {};
    if (within.contains(roots->low)) return roots->low;
    if (within.contains(roots->high)) return roots->high;
    return {};
}

// The formulas that you know from school: b^2 - 4 a c and (-b -+ root) / 2 a.
inline std::optional<Real> textbook(const Sphere& sphere, const Ray& ray, Interval within) {
    const Vec3 f = ray.origin - sphere.center, d = ray.direction;
    const Real a = dot(d, d), b = 2 * dot(f, d), c = dot(f, f) - sphere.radius * sphere.radius;
    const Real discriminant = b * b - 4 * a * c;
    if (!(a > 0 && discriminant >= 0)) return {};
    const Real root = std::sqrt(discriminant);
    return nearest_within(Roots{(-b - root) / (2 * a), (-b + root) / (2 * a)}, within);
}

// The same a, b and c, given to the stable solver. The solver is accurate for the numbers that it
// gets, but these are already rounded.
inline std::optional<Real> stable_roots(const Sphere& sphere, const Ray& ray, Interval within) {
    const Vec3 f = ray.origin - sphere.center, d = ray.direction;
    const Real a = dot(d, d), b = 2 * dot(f, d), c = dot(f, f) - sphere.radius * sphere.radius;
    return nearest_within(rt::solve_quadratic(a, b, c), within);
}

// The discriminant as a (r^2 - |nearest|^2), with the vector from the center to the nearest point
// of the line. Source: Haines, Gunther and Akenine-Moller, "Precision improvements for ray/sphere
// intersection", Ray Tracing Gems, chapter 7, 2019.
inline std::optional<Real> nearest_point(const Sphere& sphere, const Ray& ray, Interval within) {
    const Vec3 f = ray.origin - sphere.center, d = ray.direction;
    const Real r_squared = sphere.radius * sphere.radius;
    const Real a = dot(d, d), b = dot(f, d);
    if (!(a > 0)) return {};
    const Vec3 nearest = f - (b / a) * d;
    const Real half_chord_squared = r_squared - dot(nearest, nearest);
    if (!(half_chord_squared >= 0)) return {};
    return nearest_within(
        rt::roots_from_discriminant(a, 2 * b, dot(f, f) - r_squared, 4 * (a * half_chord_squared)),
        within);
}

// Like rt::hit_sphere, but with the cross product of chapter 01, whose components have errors of at
// most 1.5 units in the last place, however far away the center is.
inline std::optional<Real> exact_cross(const Sphere& sphere, const Ray& ray, Interval within) {
    const Vec3 f = ray.origin - sphere.center, d = ray.direction;
    const Real r_squared = sphere.radius * sphere.radius;
    const Real a = dot(d, d), b = dot(f, d);
    const Vec3 moment = cross(f, d);
    const Real quarter = a * r_squared - dot(moment, moment);
    if (!(a > 0 && quarter >= 0)) return {};
    return nearest_within(rt::roots_from_discriminant(a, 2 * b, dot(f, f) - r_squared, 4 * quarter),
                          within);
}

}  // namespace variants
