#pragma once
// Has a program that was compiled with recorder/ tell what the light of a sample does.

#include <companion/follow/trail.hpp>
#include <companion/system/process.hpp>

namespace companion {

// The pixel and the sample that are followed.
struct Followed {
    int column = 0, row = 0, sample = 0;
};

struct Recorded {
    Trail trail;  // without a ray if none is sent through the pixel
    Result result;
};

// Runs the command with what the recorder must know.
Recorded record(const Followed& followed, Run run);

}  // namespace companion
