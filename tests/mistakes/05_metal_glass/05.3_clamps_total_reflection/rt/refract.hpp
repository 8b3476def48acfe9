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
    const Real cosine_beyond = std::sqrt(std::max(Real(0), -excess) * (1 + eta * sine));
    return eta * cross(across, normal) - cosine_beyond * normal;
}

}  // namespace rt
