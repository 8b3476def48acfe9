#pragma once
#include <algorithm>
#include <cmath>
#include <rt/length.hpp>

namespace rt {

inline Vec3 above_horizon(Vec3 v, Vec3 normal) {
    if (v == Vec3{}) return normal;
    const Real height = dot(v, normal);
    return normalize(height < 0 ? v - 2 * height * normal : v);
}

}  // namespace rt
