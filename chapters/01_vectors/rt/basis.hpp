#pragma once
#include <rt/vec3.hpp>

namespace rt {

// Three unit vectors, each perpendicular to the others, right-handed: u x v = w.
struct Basis {
    Vec3 u, v, w;

    // The vector with these coordinates along u, v and w.
    Vec3 to_world(Vec3 local) const { return local.x * u + local.y * v + local.z * w; }
};

}  // namespace rt
