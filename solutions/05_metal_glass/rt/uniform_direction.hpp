#pragma once
#include <cmath>
#include <rt/sine_cosine.hpp>
#include <rt/vec2.hpp>
#include <rt/vec3.hpp>

namespace rt {

// Turns `place`, a sample point of the unit square with 0 <= x, y < 1, into a direction whose
// length differs from 1 by at most 2 epsilon. Random sample points, spread evenly over the square,
// become random directions, each equally likely. Source: Archimedes, "On the sphere and cylinder":
// slices of a sphere that are equally thick have equal areas.
inline Vec3 uniform_direction(Vec2 place) {
    const Real z = 1 - 2 * place.x;
    // sqrt(1 - z^2), without the cancellation near the poles.
    const Real radius = 2 * std::sqrt(place.x * (1 - place.x));
    const auto [sine, cosine] = sine_cosine_of_turn(place.y);
    return {radius * cosine, radius * sine, z};
}

}  // namespace rt
