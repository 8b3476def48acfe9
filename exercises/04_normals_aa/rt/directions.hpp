#pragma once
#include <cmath>
#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/todo.hpp>
#include <rt/vec2.hpp>

namespace rt {

// Exercise 04.3. Turns a sample point of the unit square, `place`, 0 <= x, y < 1, into a direction
// on the normal's side, of length 1. Random sample points, spread evenly over the square, become
// directions distributed by their cosine with the normal: probability density cos / pi. The normal
// must have length 1. std::sin and std::cos will do; the solution uses sine_cosine_of_turn from
// <rt/sine_cosine.hpp>, which gives the same bits with every library.
// Star: the length is within 2 epsilon of 1, even at the corners of the square, and the cosine is
// always greater than 0. Source: Malley's method: points spread evenly over a disk, lifted up to
// the hemisphere.
inline Vec3 cosine_direction(Vec3 normal, Vec2 place) {
    return rt::todo("04.3", normal, place);
}

// A random sample point of the unit square (given).
template <class Random>
Vec2 random_place(Random& random) {
    const Real x = random.uniform(), y = random.uniform();
    return {x, y};
}

}  // namespace rt
