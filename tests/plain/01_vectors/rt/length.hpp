#pragma once
#include <cmath>
#include <rt/compiler.hpp>
#include <rt/dot.hpp>
#include <rt/interval.hpp>
#include <rt/vec3.hpp>
#include <stdexcept>

namespace rt {

inline Real length(Vec3 v) {
    return std::sqrt(dot(v, v));
}

inline Vec3 normalize(Vec3 v) {
    return v / length(v);
}

}  // namespace rt
