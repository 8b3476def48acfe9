#pragma once
#include <cmath>
#include <rt/sine_cosine.hpp>
#include <rt/todo.hpp>
#include <rt/vec2.hpp>
#include <rt/vec3.hpp>

namespace rt {

// Exercise 05.2, the first part. Turns a sample point of the unit square, `place`, 0 <= x, y < 1,
// into a direction of length 1. Random sample points, spread evenly over the square, become random
// directions, each equally likely.
// Star: the length is within 2 epsilon of 1, even at the corners of the square; near the poles, the
// distance from the axis is small but must keep all its digits. Source: Archimedes, "On the sphere
// and cylinder": slices of equal thickness have equal surface.
inline Vec3 uniform_direction(Vec2 place) {
    return rt::todo("05.2", place);
}

}  // namespace rt
