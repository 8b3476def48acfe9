#pragma once
#include <algorithm>
#include <cmath>
#include <rt/length.hpp>

namespace rt {

inline Vec3 above_horizon(Vec3 v, Vec3 normal) {
    if (v == Vec3{}) return normal;
    const Real height = dot(v, normal);
    const Real least = rounding_bound(16) * (std::abs(v.x) + std::abs(v.y) + std::abs(v.z));
    return normalize(v + (std::max(height, least) - height) * normal);
}

}  // namespace rt
