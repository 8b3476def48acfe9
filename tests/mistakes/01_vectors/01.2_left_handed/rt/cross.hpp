#pragma once
#include <rt/vec3.hpp>

namespace rt {

inline Vec3 cross(Vec3 a, Vec3 b) {
    return {a.z * b.y - a.y * b.z, a.x * b.z - a.z * b.x, a.y * b.x - a.x * b.y};
}

}  // namespace rt
