#pragma once
#include <cmath>
#include <optional>
#include <rt/cross.hpp>
#include <rt/length.hpp>

namespace rt {

inline std::optional<Vec3> refract(Vec3 incoming, Vec3 normal, Real eta) {
    if (eta == 1) return incoming;
    const Vec3 across = cross(normal, incoming);
    const Real sine = length(across);
    const Real excess = std::fma(eta, sine, Real(-1));
    if (excess > 0) return {};
    const Real cosine_beyond = std::sqrt(-excess * (1 + eta * sine));
    return eta * cross(normal, across) - cosine_beyond * normal;
}

}  // namespace rt
