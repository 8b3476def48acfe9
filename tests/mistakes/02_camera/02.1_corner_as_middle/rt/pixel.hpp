#pragma once
#include <rt/camera.hpp>

namespace rt {

inline Vec2 pixel_to_viewport(const Camera& camera, int column, int row, Vec2 offset) {
    const Real right = (static_cast<Real>(column) + offset.x) / static_cast<Real>(camera.width);
    const Real up = 1 - (static_cast<Real>(row) + offset.y) / static_cast<Real>(camera.height);
    return {right * camera.viewport.width, up * camera.viewport.height};
}

}  // namespace rt
