#pragma once
#include <rt/real.hpp>

namespace rt {

// A lens instead of a pinhole (given). Whatever is at the distance of focus is sharp.
struct Lens {
    Real aperture = 0;        // the diameter of the lens, 0 or more; 0 is a pinhole
    Real focus_distance = 1;  // from the eye along the direction of view, greater than 0
};

}  // namespace rt
