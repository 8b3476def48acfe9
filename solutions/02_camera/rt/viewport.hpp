#pragma once
#include <cmath>
#include <rt/camera.hpp>
#include <stdexcept>

namespace rt {

// The point of the viewport that a pixel shows: x to the right, y up, (0, 0) in the middle.
// column and row count from the top left; offset in [0, 1] x [0, 1] is the place within the pixel,
// from its top left corner: (0.5, 0.5) is its middle.
inline Vec2 pixel_to_viewport(const Camera& camera, int column, int row, Vec2 offset) {
    const Real right = (static_cast<Real>(column) + offset.x) / static_cast<Real>(camera.width);
    const Real down = (static_cast<Real>(row) + offset.y) / static_cast<Real>(camera.height);
    return {(right - Real(0.5)) * camera.viewport.width,
            (Real(0.5) - down) * camera.viewport.height};
}

// The viewport at distance 1 for a vertical field of view in radians and the ratio of width to
// height. Throws std::domain_error unless 0 < vertical_fov < pi and 0 < aspect_ratio < infinity.
inline Viewport viewport_size(Real vertical_fov, Real aspect_ratio) {
    if (!(0 < vertical_fov && vertical_fov < pi))
        throw std::domain_error("the field of view must lie between 0 and 180 degrees");
    if (!(0 < aspect_ratio && aspect_ratio < infinity))
        throw std::domain_error("the aspect ratio must be greater than 0");
    const Real height = 2 * std::tan(vertical_fov / 2);
    return {height * aspect_ratio, height};
}

}  // namespace rt
