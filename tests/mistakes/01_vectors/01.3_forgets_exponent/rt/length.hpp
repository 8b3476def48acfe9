#pragma once
#include <rt/dot.hpp>
#include <rt/vec3.hpp>
#include <stdexcept>

namespace rt {

inline Real length(Vec3 v) {
    if (const Real squared = dot(v, v); squared > Real(1e-18) && squared < Real(1e18))
        return std::sqrt(squared);
    const ScaledVec3 s = split_scale(v);
    return std::sqrt(dot(s.v, s.v));
}

inline Vec3 normalize(Vec3 v) {
    const Vec3 s = split_scale(v).v;
    if (!(dot(s, s) > 0) || !is_finite(s)) throw std::domain_error("no direction");
    return s / std::sqrt(dot(s, s));
}

}  // namespace rt
