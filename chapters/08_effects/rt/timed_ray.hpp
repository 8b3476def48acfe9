#pragma once
#include <rt/ray.hpp>

namespace rt {

// A ray with a time (given): 0 as the shutter opens, 1 as it closes. The path loop passes the time
// on from bounce to bounce without knowing about it. Code that does not need the time uses the
// TimedRay as a plain Ray.
struct TimedRay {
    Vec3 origin, direction;
    Real time = 0;

    operator Ray() const { return {origin, direction}; }
};

}  // namespace rt
