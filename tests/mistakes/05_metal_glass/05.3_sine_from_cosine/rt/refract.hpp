#pragma once
#include <cmath>
#include <optional>
#include <rt/cross.hpp>
#include <rt/length.hpp>

namespace rt {

inline std::optional<Vec3> refract(Vec3 incoming, Vec3 normal, Real eta) {
    if (eta == 1) return incoming;
    const Real cosine = std::min(-dot(incoming, normal), Real(1));
    const Real sine = std::sqrt(1 - cosine * cosine);
    if (eta * sine > 1) return {};
    const Vec3 along = eta * (incoming + cosine * normal);
    return along - std::sqrt(std::abs(1 - dot(along, along))) * normal;
}

}  // namespace rt
