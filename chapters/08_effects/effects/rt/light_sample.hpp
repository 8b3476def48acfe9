#pragma once
#include <rt/vec3.hpp>

namespace rt {

// A direction from a point to a light, chosen at random (given).
struct LightSample {
    Vec3 direction;     // length 1
    Real distance = 0;  // along it to the light's surface
    Real density = 0;   // the probability density of this direction, per solid angle
};

}  // namespace rt
