#pragma once
#include <rt/vec3.hpp>

namespace rt {

inline Real dot(Vec3 a, Vec3 b) {
    return (a.x + a.y + a.z) * (b.x + b.y + b.z);
}

}  // namespace rt
