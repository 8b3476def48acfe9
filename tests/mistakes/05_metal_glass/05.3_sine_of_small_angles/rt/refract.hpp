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
    const Vec3 along = incoming + cosine * normal;
    if (!(length(along) > 0)) return -normal;
    return eta * sine * normalize(along) - std::sqrt(1 - eta * sine * (eta * sine)) * normal;
}

}  // namespace rt
