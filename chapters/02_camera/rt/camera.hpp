#pragma once
#include <rt/basis.hpp>
#include <rt/vec2.hpp>
#include <rt/view.hpp>

namespace rt {

// The window through which a camera looks: width and height at distance 1 from the eye.
struct Viewport {
    Real width = 2, height = 2;
};

// A pinhole camera, in the form that rays are made from. It looks along -w; u points right and v
// up.
struct Camera {
    Vec3 eye;
    Basis basis;
    Viewport viewport;
    int width = 1, height = 1;  // pixels
};

}  // namespace rt
