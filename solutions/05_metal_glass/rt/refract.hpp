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
    // The part along the surface, times eta: its length is the sine of the angle behind it.
    const Real cosine = -dot(incoming, normal);
    const Vec3 along = eta * (incoming + cosine * normal);
    Real squared_cosine = 1 - dot(along, along);
    // Too close to call: 3 roundings of each component of `along`, and 6 of the sum, have a say.
    if (std::abs(squared_cosine) <= rounding_bound(8) * (1 + eta)) {
        // The sine again, from a cross product, where nothing cancels. eta * sine - 1 is rounded
        // once, so that its sign is right.
        const Real sine = length(cross(normal, incoming));
        const Real excess = std::fma(eta, sine, Real(-1));
        squared_cosine = -excess * (1 + eta * sine);
    }
    if (squared_cosine < 0) return {};
    return along - std::sqrt(squared_cosine) * normal;
}

}  // namespace rt
