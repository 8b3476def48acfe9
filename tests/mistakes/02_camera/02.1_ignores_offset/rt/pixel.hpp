#pragma once
#include <rt/camera.hpp>

namespace rt {

inline Vec2 pixel_to_viewport(const Camera& camera, int column, int row, Vec2 offset) {
    static_cast<void>(offset);
    const Real right = static_cast<Real>(2 * column + 1 - camera.width) / 2;
    const Real up = static_cast<Real>(camera.height - 2 * row - 1) / 2;
    return {right / static_cast<Real>(camera.width) * camera.viewport.width,
            up / static_cast<Real>(camera.height) * camera.viewport.height};
}

}  // namespace rt
