#pragma once
#include <rt/dot.hpp>
#include <rt/vec3.hpp>

namespace rt {

inline int facing(Vec3 normal, Vec3 to_viewer) {
    const Real c = dot(normal, to_viewer);
    return (c >= 1) - (c <= -1);
}

}  // namespace rt
