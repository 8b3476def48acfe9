#pragma once
#include <cmath>
#include <optional>
#include <rt/cross.hpp>
#include <rt/length.hpp>

namespace rt {

inline std::optional<Vec3> refract(Vec3 incoming, Vec3 normal, Real eta) {
    if (eta == 1) return incoming;
    const Real cosine = -dot(incoming, normal);
    const Vec3 along = eta * (incoming + cosine * normal);
    Real squared_cosine = 1 - dot(along, along);
    if (std::abs(squared_cosine) <= rounding_bound(8) * (1 + eta)) {
        const Real sine = length(cross(normal, incoming));
        const Real excess = std::fma(eta, sine, Real(-1));
        squared_cosine = -excess;
    }
    if (squared_cosine < 0) return {};
    return along - std::sqrt(squared_cosine) * normal;
}

}  // namespace rt
