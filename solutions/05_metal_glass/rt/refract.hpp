#pragma once
#include <cmath>
#include <optional>
#include <rt/cross.hpp>
#include <rt/length.hpp>

namespace rt {

// The direction of light that arrives along `incoming` and passes through the surface. `normal`
// points to the side that the light comes from; both have length 1. eta, greater than 0, is the
// index of refraction on that side divided by the index on the other side. None at total
// reflection: when eta times the sine of the angle between `incoming` and the normal exceeds 1. If
// eta = 1, the direction stays as it is, bit for bit. Source: Snell's law.
inline std::optional<Vec3> refract(Vec3 incoming, Vec3 normal, Real eta) {
    if (eta == 1) return incoming;
    // The part of `incoming` along the surface, times eta. The length of `along` is the sine of the
    // refraction angle.
    const Real cosine = -dot(incoming, normal);
    const Vec3 along = eta * (incoming + cosine * normal);
    Real squared_cosine = 1 - dot(along, along);
    // Too close to call: 3 roundings in each component of `along` and 6 in the sum could decide the
    // sign.
    if (std::abs(squared_cosine) <= rounding_bound(8) * (1 + eta)) {
        // The sine again, from a cross product, in which nothing cancels. eta * sine - 1 is rounded
        // only once, so its sign is right.
        const Real sine = length(cross(normal, incoming));
        const Real excess = std::fma(eta, sine, Real(-1));
        squared_cosine = -excess * (1 + eta * sine);
    }
    if (squared_cosine < 0) return {};
    return along - std::sqrt(squared_cosine) * normal;
}

}  // namespace rt
