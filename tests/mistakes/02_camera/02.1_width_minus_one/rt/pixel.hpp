#pragma once
#include <rt/camera.hpp>

namespace rt {

inline Vec2 pixel_to_viewport(const Camera& camera, int column, int row, Vec2 offset) {
    const Real right = (static_cast<Real>(column) + offset.x) / static_cast<Real>(camera.width - 1);
    const Real down = (static_cast<Real>(row) + offset.y) / static_cast<Real>(camera.height - 1);
    return {(right - Real(0.5)) * camera.viewport.width,
            (Real(0.5) - down) * camera.viewport.height};
}

}  // namespace rt
