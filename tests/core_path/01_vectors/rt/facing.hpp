#pragma once
#include <rt/dot.hpp>

namespace rt {
inline int facing(Vec3 normal, Vec3 to_viewer) {
    const Real d = dot(normal, to_viewer);
    if (d > 0) return 1;
    if (d < 0) return -1;
    return 0;
}
}  // namespace rt
