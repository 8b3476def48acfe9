#pragma once
#include <rt/vec3.hpp>

namespace rt {

// A half line: the points origin + t * direction for t >= 0. The direction need not have length 1.
struct Ray {
    Vec3 origin;
    Vec3 direction;

    Vec3 at(Real t) const { return origin + t * direction; }
};

}  // namespace rt
