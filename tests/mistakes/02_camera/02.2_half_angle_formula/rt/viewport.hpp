#pragma once
#include <cmath>
#include <rt/camera.hpp>
#include <stdexcept>

namespace rt {

inline Viewport viewport_size(Real vertical_fov, Real aspect_ratio) {
    if (!(0 < vertical_fov && vertical_fov < pi))
        throw std::domain_error("the field of view must lie between 0 and 180 degrees");
    if (!(0 < aspect_ratio && aspect_ratio < infinity))
        throw std::domain_error("the aspect ratio must be greater than 0 and finite");
    const Real c = std::cos(vertical_fov);
    const Real height = 2 * std::sqrt((1 - c) / (1 + c));
    return {height * aspect_ratio, height};
}

}  // namespace rt
