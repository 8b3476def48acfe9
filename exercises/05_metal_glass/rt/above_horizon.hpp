#pragma once
#include <algorithm>
#include <cmath>
#include <rt/length.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 05.2, the second part. The direction of v, folded to the normal's side of the surface:
// if v points below, it is mirrored at the surface. v may have any length that is far from the
// smallest and the largest numbers; the result has length 1.
// Star: its computed dot product with the normal is greater than 0, whatever the rounding. To
// ensure this, any height below rounding_bound(16) times the length of v is raised to that bound,
// or to a little more. A zero v has no direction, so it gives the normal.
inline Vec3 above_horizon(Vec3 v, Vec3 normal) {
    return rt::todo("05.2", v, normal);
}

}  // namespace rt
