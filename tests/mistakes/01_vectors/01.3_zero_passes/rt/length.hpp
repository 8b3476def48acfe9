#pragma once
#include <rt/dot.hpp>
#include <rt/vec3.hpp>
#include <stdexcept>

namespace rt {

inline Real length(Vec3 v) {
    const ScaledVec3 s = split_scale(v);
    return std::scalbn(std::sqrt(dot(s.v, s.v)), s.exponent);
}

inline Vec3 normalize(Vec3 v) {
    const Vec3 s = split_scale(v).v;
    return s / std::sqrt(dot(s, s));
}

}  // namespace rt
