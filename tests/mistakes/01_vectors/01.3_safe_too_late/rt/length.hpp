#pragma once
#include <cmath>
#include <rt/dot.hpp>
#include <rt/vec3.hpp>
#include <stdexcept>

namespace rt {

inline Real length(Vec3 v) {
    const ScaledVec3 s = split_scale(v);
    return std::scalbn(std::sqrt(dot(s.v, s.v)), s.exponent);
}

inline Vec3 normalize(Vec3 v) {
    const Real squared = dot(v, v);
    if (squared > 0 && squared < infinity) return v / std::sqrt(squared);
    const Vec3 s = split_scale(v).v;
    if (!(dot(s, s) > 0) || !is_finite(s)) throw std::domain_error("no direction");
    return s / std::sqrt(dot(s, s));
}

}  // namespace rt
