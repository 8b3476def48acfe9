#pragma once
#include <rt/dot.hpp>

namespace rt {

inline Vec3 reflect(Vec3 incoming, Vec3 normal) {
    return incoming + 2 * dot(incoming, normal) * normal;
}

}  // namespace rt
