#pragma once
#include <rt/vec3_type.hpp>

namespace rt {

struct Sphere {
    Vec3 center;
    Real radius = 1;  // greater than 0
};

// The same sphere, moved by a vector.
inline Sphere moved(const Sphere& sphere, Vec3 by) {
    const Vec3 c = sphere.center;
    return {{c.x + by.x, c.y + by.y, c.z + by.z}, sphere.radius};
}

}  // namespace rt
