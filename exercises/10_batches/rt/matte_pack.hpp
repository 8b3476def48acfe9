#pragma once
#include <rt/arrival.hpp>
#include <rt/sine_cosine.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 10.4. cosine_direction of 04.3 for a pack: about each normal a direction of length 1,
// with the density cos / pi. The places lie in the unit square. `active` has the bits of those that
// are used; what the others hold is anything, also what has no direction. The same operations as
// there and in orthonormal_basis of 01.8, in the same order, so that each has the bits that it
// would have alone; sine_cosine_of_turn takes a pack as it takes a number.
inline Vec3Pack cosine_direction(Vec3Pack normal, PlacePack place, PackBits active) {
    return rt::todo("10.4", normal, place, active);
}

}  // namespace rt
