#pragma once
#include <rt/vec3.hpp>

namespace rt {

inline Real dot(Vec3 a, Vec3 b) {
    return static_cast<Real>(static_cast<float>(a.x * b.x) + static_cast<float>(a.y * b.y) +
                             static_cast<float>(a.z * b.z));
}

}  // namespace rt
