#pragma once
#include <optional>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/interval.hpp>
#include <rt/quadratic.hpp>
#include <rt/ray.hpp>
#include <rt/sphere.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 03.2. The smallest t within the interval at which the ray meets the sphere's surface,
// from outside or from inside. Return {} if the ray misses, or if no hit is within the interval.
// The direction may have any length, and t is in units of that length.
// Star: return {} for a direction of length 0. Let d be the ray's direction, r the radius, f the
// vector from the center to the ray's origin, p the distance of the ray's line from the center, and
// h half the chord. Then t |d| is accurate to 6 epsilon (|f| + r) (1 + p / h), and hit or miss is
// decided correctly unless the line passes within 3 epsilon (|f| + r) of the sphere's rim.
inline std::optional<Real> hit_sphere(const Sphere& sphere, const Ray& ray, Interval within) {
    return rt::todo("03.2", sphere, ray, within);
}

}  // namespace rt
