#pragma once
#include <cmath>
#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/todo.hpp>
#include <rt/vec2.hpp>

namespace rt {

// Exercise 04.3. Both functions turn a place of the unit square, 0 <= x, y < 1, into a direction of
// length 1 within 2 epsilon. Random places, spread evenly over the square, become random
// directions. std::sin and std::cos are right; the solution takes sine_cosine_of_turn of
// <rt/sine_cosine.hpp>, whose bits are the same with every library.

// Every direction is equally likely. Near the poles, where the distance from the axis is small, it
// keeps its digits all the same. Source: Archimedes, "On the sphere and cylinder": slices of
// equal thickness have equal surface.
inline Vec3 uniform_direction(Vec2 place) {
    return rt::todo("04.3", place);
}

// A direction on the normal's side, as likely as its cosine with the normal: density cos / pi. The
// normal must have length 1. The cosine is always greater than 0.
// Source: Malley's method: places spread evenly over a disk, lifted up to the hemisphere.
inline Vec3 cosine_direction(Vec3 normal, Vec2 place) {
    return rt::todo("04.3", normal, place);
}

// A random place of the unit square (given).
template <class Random>
Vec2 random_place(Random& random) {
    const Real x = random.uniform(), y = random.uniform();
    return {x, y};
}

}  // namespace rt
