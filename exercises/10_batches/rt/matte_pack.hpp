#pragma once
#include <rt/arrival.hpp>
#include <rt/sine_cosine.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 10.4. cosine_direction of 04.3 for a pack: for each normal, of length 1, a direction of
// length 1 with the probability density cos / pi around the normal. `place` has sample points of
// the unit square, 0 <= x, y < 1. Use the same operations in the same order as cosine_direction and
// as orthonormal_basis of 01.8, so that each result has the same bits as for a single normal.
// Star: `active` has a bit set for each lane in use; any combination may occur. The other lanes may
// hold anything, even vectors without a direction or NaN: their results do not matter, but they
// must not make the function throw.
inline Vec3Pack cosine_direction(Vec3Pack normal, PlacePack place, PackBits active) {
    return rt::todo("10.4", normal, place, active);
}

}  // namespace rt
