#pragma once
#include <rt/dot.hpp>
#include <rt/vec3.hpp>
#include <stdexcept>

namespace rt {

inline Real length(Vec3 v) {
    return dot(v, v);
}

inline Vec3 normalize(Vec3 v) {
    const Vec3 s = split_scale(v).v;
    if (!(dot(s, s) > 0) || !is_finite(s)) throw std::domain_error("no direction");
    return s / std::sqrt(dot(s, s));
}

}  // namespace rt
