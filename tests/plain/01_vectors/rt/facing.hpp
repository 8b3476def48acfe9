#pragma once
#include <rt/dot.hpp>
#include <rt/vec3.hpp>

namespace rt {

inline int facing(Vec3 normal, Vec3 to_viewer) {
    const Real cosine = dot(normal, to_viewer);
    if (cosine > 0) return 1;
    return cosine < 0 ? -1 : 0;
}

}  // namespace rt
