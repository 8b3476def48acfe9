#pragma once
#include <optional>
#include <rt/above_horizon.hpp>
#include <rt/directions.hpp>
#include <rt/hit.hpp>
#include <rt/reflect.hpp>
#include <rt/scatter.hpp>
#include <rt/todo.hpp>
#include <rt/uniform_direction.hpp>

namespace rt {

// A metal: from a mirror (fuzz 0) to a rough, dull shine (fuzz 1).
struct Metal {
    Color albedo;   // the fraction of light that comes back, each channel in [0, 1]
    Real fuzz = 0;  // how far reflected light strays from the mirror direction, in [0, 1]
};

// Exercise 05.2, the third part. Where metal sends light that arrives along `incoming` (of length
// 1) on the side to which `normal` points: the mirror direction plus `fuzz` times the uniform
// direction for `place`, a sample point of the unit square, folded above the surface. The result
// has length 1.
inline Vec3 metal_direction(Vec3 incoming, Vec3 normal, Real fuzz, Vec2 place) {
    return rt::todo("05.2", incoming, normal, fuzz, place);
}

// Exercise 05.2, the fourth part. How a path goes on from metal. It is never absorbed, and its
// light is multiplied by the albedo. Use facing_normal(hit) and random_place(random); a mirror,
// with fuzz 0, need not draw a random place.
template <class Random>
std::optional<Scatter> scatter(const Metal& material, Vec3 incoming, const Hit& hit,
                               Random& random) {
    return rt::todo("05.2", material, incoming, hit, random);
}

}  // namespace rt
