#pragma once
#include <rt/arrival.hpp>
#include <rt/sine_cosine.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 10.4. cosine_direction of 04.3 for a pack: about each normal, of length 1, a direction
// of length 1, with the density cos / pi. The places lie in the unit square, 0 <= x, y < 1.
// `active` has the bits of those that are used, any of them; what the others hold is anything, also
// what has no direction or is no number: their results do not matter, and they must not make it
// throw. The same operations as there and in orthonormal_basis of 01.8, in the same order, so that
// each has the bits that it would have alone; sine_cosine_of_turn takes a pack as it takes a
// number.
inline Vec3Pack cosine_direction(Vec3Pack normal, PlacePack place, PackBits active) {
    return rt::todo("10.4", normal, place, active);
}

}  // namespace rt
