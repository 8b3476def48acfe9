#pragma once
#include <rt/color.hpp>
#include <rt/vec3_type.hpp>

namespace rt {

// What is known about a pixel, without any noise: the surface that its eye ray meets.
struct Features {
    Color albedo;  // may be more than 1 for a lamp
    Vec3 normal;   // 0 for the sky
};

// How far a pixel's light may spread: a width for each of three distances, in the picture, between
// albedos and between normals. A distance of one width multiplies the weight by exp(-1/2), which is
// 0.61. Widths are greater than 0; if a width is infinite, its distance does not count.
struct DenoiseWidths {
    int radius = 6;  // pixels; those farther away across or down do not count; 0 or more
    Real space = 3;  // pixels
    Real albedo = Real(0.1);
    Real normal = Real(0.2);
    Real darkest = Real(0.02);  // a smaller albedo counts as this; greater than 0
};

}  // namespace rt
