#pragma once
#include <cmath>
#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/sine_cosine.hpp>
#include <rt/vec2.hpp>

namespace rt {

// Turns `place`, a sample point of the unit square with 0 <= x, y < 1, into a direction on the
// normal's side, whose length differs from 1 by at most 2 epsilon. Random sample points, spread
// evenly over the square, become random directions distributed by their cosine with the normal:
// probability density cos / pi. The normal must have length 1. The cosine is always greater than 0.
// Source: Malley's method: points spread evenly over a disk, lifted up to the hemisphere.
inline Vec3 cosine_direction(Vec3 normal, Vec2 place) {
    const Real radius = std::sqrt(place.x);
    const auto [sine, cosine] = sine_cosine_of_turn(place.y);
    const Real height = std::sqrt(1 - place.x);  // at least sqrt(epsilon / 2), since x < 1
    return normalize(orthonormal_basis(normal).to_world({radius * cosine, radius * sine, height}));
}

// A random sample point of the unit square (given).
template <class Random>
Vec2 random_place(Random& random) {
    const Real x = random.uniform(), y = random.uniform();
    return {x, y};
}

}  // namespace rt
