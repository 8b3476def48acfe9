#pragma once
#include <rt/basis.hpp>
#include <rt/vec2.hpp>

namespace rt {

// Where a camera stands and what it sees, as a person describes it.
struct View {
    Vec3 from{0, 0, 0};
    Vec3 at{0, 0, -1};           // the point in the middle of the picture
    Vec3 up{0, 1, 0};            // what shall point upwards in the picture; any length but 0
    Real vertical_fov = pi / 2;  // radians, between 0 and pi: from the lower to the upper edge
};

// The window through which a camera looks: width and height at distance 1 from the eye.
struct Viewport {
    Real width = 2, height = 2;
};

// A pinhole camera, as rays are made from it. It looks along -w; u points right and v up.
struct Camera {
    Vec3 eye;
    Basis basis;
    Viewport viewport;
    int width = 1, height = 1;  // pixels
};

}  // namespace rt
