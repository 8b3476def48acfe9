#pragma once
#include <rt/dot.hpp>
#include <rt/todo.hpp>
#include <rt/vec3.hpp>

namespace rt {

// Exercise 01.5. Which side of a surface with this outward normal a viewer is on: +1 in front (the
// angle between the normal and the direction to the viewer is less than 90 degrees), -1 behind, 0
// exactly edge-on. Neither vector needs to have length 1.
// Star: a zero vector gives 0, and tiny and huge vectors have a side, too. Any side will do where
// rounding decides: if the dot product is no farther from 0 than rounding_bound(3) times the sum of
// its terms' absolute values, or if the angle is within 10^-307 of a right angle (float: 10^-37),
// where even scaled products underflow.
inline int facing(Vec3 normal, Vec3 to_viewer) {
    return rt::todo("01.5", normal, to_viewer);
}

}  // namespace rt
