#pragma once
#include <rt/camera.hpp>

namespace rt {

inline Vec2 pixel_to_viewport(const Camera& camera, int column, int row, Vec2 offset) {
    const Real width = static_cast<Real>(camera.width), height = static_cast<Real>(camera.height);
    const Real right = (static_cast<Real>(column) - width / 2) + offset.x;
    const Real down = (static_cast<Real>(row) - height / 2) + offset.y;
    return {right / width * camera.viewport.width, down / height * camera.viewport.height};
}

}  // namespace rt
