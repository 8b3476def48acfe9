#pragma once
#include <rt/camera.hpp>

namespace rt {
inline Vec2 pixel_to_viewport(const Camera& camera, int column, int row, Vec2 offset) {
    const Real x =
        (static_cast<Real>(column) + offset.x) / static_cast<Real>(camera.width) - Real(0.5);
    const Real y =
        Real(0.5) - (static_cast<Real>(row) + offset.y) / static_cast<Real>(camera.height);
    return {x * camera.viewport.width, y * camera.viewport.height};
}
}  // namespace rt
