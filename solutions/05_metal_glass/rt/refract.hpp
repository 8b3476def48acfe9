#pragma once
#include <cmath>
#include <optional>
#include <rt/cross.hpp>
#include <rt/length.hpp>

namespace rt {

// Where light goes that arrives along `incoming` and enters what lies behind the surface. `normal`
// points to the side that the light comes from; both have length 1. eta is the index of refraction
// there divided by the one behind, greater than 0. None where all light is reflected: where eta
// times the sine of the angle to the normal exceeds 1. With eta = 1 the direction stays as it is,
// bit for bit. Source: Snell's law.
inline std::optional<Vec3> refract(Vec3 incoming, Vec3 normal, Real eta) {
    if (eta == 1) return incoming;
    // As long as the sine of the angle. Other than 1 - cosine^2 it is accurate for every angle.
    const Vec3 across = cross(normal, incoming);
    const Real sine = length(across);
    // eta * sine - 1, rounded once: its sign, which decides, is right.
    const Real excess = std::fma(eta, sine, Real(-1));
    if (excess > 0) return {};
    const Real cosine_beyond = std::sqrt(-excess * (1 + eta * sine));
    // across x normal is the part of `incoming` along the surface.
    return eta * cross(across, normal) - cosine_beyond * normal;
}

}  // namespace rt
