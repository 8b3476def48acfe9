#pragma once
#include <rt/camera.hpp>

namespace rt {

inline Vec2 pixel_to_viewport(const Camera& camera, int column, int row, Vec2 offset) {
    const Real right = static_cast<Real>(column / camera.width) + offset.x;
    const Real down = static_cast<Real>(row / camera.height) + offset.y;
    return {(right - Real(0.5)) * camera.viewport.width,
            (Real(0.5) - down) * camera.viewport.height};
}

}  // namespace rt
