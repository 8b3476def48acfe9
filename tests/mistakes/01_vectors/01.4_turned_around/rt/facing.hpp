#pragma once
#include <rt/dot.hpp>
#include <rt/vec3.hpp>

namespace rt {

inline int facing(Vec3 normal, Vec3 to_viewer) {
    const Real c = dot(split_scale(normal).v, split_scale(to_viewer).v);
    return (c < 0) - (c > 0);
}

}  // namespace rt
