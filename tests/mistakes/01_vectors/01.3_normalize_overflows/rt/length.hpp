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
    if (v == Vec3{} || !is_finite(v)) throw std::domain_error("no direction");
    return v / std::sqrt(dot(v, v));
}

}  // namespace rt
