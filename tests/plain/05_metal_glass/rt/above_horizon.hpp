#pragma once
#include <algorithm>
#include <cmath>
#include <rt/length.hpp>
#include <rt/reflect.hpp>

namespace rt {

inline Vec3 above_horizon(Vec3 v, Vec3 normal) {
    const Vec3 up = dot(v, normal) < 0 ? reflect(v, normal) : v;
    return normalize(up);
}

}  // namespace rt
