#pragma once
#include <rt/dot.hpp>

namespace rt {

inline Vec3 reflect(Vec3 incoming, Vec3 normal) {
    const Real cosine = dot(incoming, normal);
    if (std::abs(cosine) < Real(1e-6)) return incoming;
    return incoming - 2 * cosine * normal;
}

}  // namespace rt
