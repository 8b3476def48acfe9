#pragma once
#include <rt/camera.hpp>
#include <rt/portable.hpp>
#include <stdexcept>

namespace rt {

inline Viewport viewport_size(Real vertical_fov, Real aspect_ratio) {
    const Real height = 2 * std::tan(vertical_fov / 2);
    return {height * aspect_ratio, height};
}

}  // namespace rt
