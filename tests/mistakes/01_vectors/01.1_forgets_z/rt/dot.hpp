#pragma once
#include <rt/vec3.hpp>

namespace rt {

inline Real dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y;
}

}  // namespace rt
