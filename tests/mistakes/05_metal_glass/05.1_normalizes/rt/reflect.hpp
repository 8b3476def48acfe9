#pragma once
#include <rt/length.hpp>

namespace rt {

inline Vec3 reflect(Vec3 incoming, Vec3 normal) {
    return normalize(incoming - 2 * dot(incoming, normal) * normal);
}

}  // namespace rt
