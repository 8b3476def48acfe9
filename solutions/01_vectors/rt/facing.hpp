#pragma once
#include <rt/dot.hpp>
#include <rt/vec3.hpp>

namespace rt {

// Which side of a surface with this outward normal a viewer is on: +1 in front (the angle between
// the normal and the direction to the viewer is less than 90 degrees), -1 behind, 0 exactly
// edge-on. Neither vector needs to have length 1; a zero vector gives 0. Rounding decides the sign
// if the dot product is no farther from 0 than rounding_bound(3) times the sum of its terms'
// absolute values, or if the angle is within 10^-307 of a right angle (float: 10^-37), where even
// scaled products underflow.
inline int facing(Vec3 normal, Vec3 to_viewer) {
    // Scaled, because the products of two tiny vectors would all underflow to a wrong 0.
    const Real cosine = dot(split_scale(normal).v, split_scale(to_viewer).v);
    return (cosine > 0) - (cosine < 0);
}

}  // namespace rt
