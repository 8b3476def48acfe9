#pragma once
#include <rt/dot.hpp>

namespace rt {

inline Vec3 reflect(Vec3 incoming, Vec3 normal) {
    return 2 * dot(incoming, normal) * normal - incoming;
}

}  // namespace rt
