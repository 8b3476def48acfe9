#pragma once
#include <rt/vec3.hpp>

namespace rt {

// A ray that knows when it is (given): 0 as the shutter opens, 1 as it closes. The path loop hands
// the time on from bounce to bounce without knowing of it.
struct TimedRay {
    Vec3 origin, direction;
    Real time = 0;
};

}  // namespace rt
