#pragma once
#include <rt/vec3.hpp>

namespace rt {

struct Sphere {
    Vec3 center;
    Real radius = 1;  // greater than 0
};

// The same sphere, moved by a vector.
inline Sphere moved(const Sphere& sphere, Vec3 by) {
    return {sphere.center + by, sphere.radius};
}

}  // namespace rt
