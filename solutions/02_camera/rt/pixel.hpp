#pragma once
#include <rt/camera.hpp>

namespace rt {

// The point of the viewport that a pixel shows: x to the right, y up, (0, 0) in the middle.
// `column` and `row` count from the top left. `offset`, in [0, 1] x [0, 1], is the point within the
// pixel, measured from the pixel's top left corner: (0.5, 0.5) is its middle. Both results are
// accurate to 3 units in the last place.
inline Vec2 pixel_to_viewport(const Camera& camera, int column, int row, Vec2 offset) {
    const Real width = static_cast<Real>(camera.width), height = static_cast<Real>(camera.height);
    // The distance from the middle in pixels. Subtracting half of the size first is exact.
    const Real right = (static_cast<Real>(column) - width / 2) + offset.x;
    const Real down = (static_cast<Real>(row) - height / 2) + offset.y;
    return {right / width * camera.viewport.width, -down / height * camera.viewport.height};
}

}  // namespace rt
