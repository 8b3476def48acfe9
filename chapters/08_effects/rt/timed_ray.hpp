#pragma once
#include <rt/vec3.hpp>

namespace rt {

// A ray with a time (given): 0 as the shutter opens, 1 as it closes. The path loop passes the time
// on from bounce to bounce without knowing about it.
struct TimedRay {
    Vec3 origin, direction;
    Real time = 0;
};

}  // namespace rt
