#pragma once
#include <rt/dot.hpp>

namespace rt {

inline Vec3 reflect(Vec3 incoming, Vec3 normal) {
    return incoming - dot(incoming, normal) * normal;
}

}  // namespace rt
