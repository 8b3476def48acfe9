#pragma once
#include <cmath>
#include <rt/length.hpp>

namespace rt {
inline Vec3 above_horizon(Vec3 v, Vec3 normal) {
    const Real h = dot(v, normal);
    return normalize(v + (std::abs(h) - h) * normal);
}
}  // namespace rt
