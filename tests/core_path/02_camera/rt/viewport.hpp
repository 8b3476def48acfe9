#pragma once
#include <cmath>
#include <rt/camera.hpp>

namespace rt {
inline Viewport viewport_size(Real vertical_fov, Real aspect_ratio) {
    const Real height = 2 * std::tan(vertical_fov / 2);
    return {height * aspect_ratio, height};
}
}  // namespace rt
