#pragma once
#include <rt/vec3.hpp>

namespace rt {

struct Sphere {
    Vec3 center;
    Real radius = 1;  // greater than 0
};

}  // namespace rt
