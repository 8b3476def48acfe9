#pragma once
#include <rt/camera.hpp>

namespace rt {

inline Vec2 pixel_to_viewport(const Camera& camera, int column, int row, Vec2 offset) {
    const Real width = static_cast<Real>(camera.width), height = static_cast<Real>(camera.height);
    const Real across = (static_cast<Real>(column) + offset.x) / width;
    const Real down = (static_cast<Real>(row) + offset.y) / height;
    return {(across - Real(0.5)) * camera.viewport.width,
            (Real(0.5) - down) * camera.viewport.height};
}

}  // namespace rt
