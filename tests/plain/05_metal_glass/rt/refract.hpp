#pragma once
#include <cmath>
#include <optional>
#include <rt/cross.hpp>
#include <rt/length.hpp>

namespace rt {

inline std::optional<Vec3> refract(Vec3 incoming, Vec3 normal, Real eta) {
    const Real cosine = -dot(incoming, normal);
    const Vec3 along = eta * (incoming + cosine * normal);
    const Real squared_cosine = 1 - dot(along, along);
    if (squared_cosine < 0) return {};
    return along - std::sqrt(squared_cosine) * normal;
}

}  // namespace rt
