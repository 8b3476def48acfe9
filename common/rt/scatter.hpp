#pragma once
#include <rt/color.hpp>
#include <rt/vec3_type.hpp>

namespace rt {

// How a path goes on from a surface.
struct Scatter {
    Color attenuation;  // what the light is multiplied by; 1 keeps all of it
    Vec3 direction;     // length 1
};

}  // namespace rt
