#pragma once
#include <array>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/reflect.hpp>
#include <rt/triangle.hpp>

namespace rt {

inline Vec3 smooth_normal(const std::array<Vec3, 3>& normals, Real u, Real v, Vec3) {
    return normalize((1 - u - v) * normals[0] + u * normals[1] + v * normals[2]);
}

inline Vec3 bent_normal(Vec3 smooth, Vec3, Vec3) {
    return smooth;
}

inline Vec3 lift(const Triangle&, const std::array<Vec3, 3>&, Real, Real) {
    return {};
}

inline Vec3 keep_side(Vec3 direction, Vec3 smooth, Vec3 flat) {
    if (dot(direction, smooth) * dot(direction, flat) >= 0) return direction;
    return reflect(direction, flat);
}

}  // namespace rt
