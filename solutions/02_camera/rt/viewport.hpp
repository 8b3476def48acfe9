#pragma once
#include <rt/camera.hpp>
#include <rt/portable.hpp>
#include <stdexcept>

namespace rt {

// The viewport at distance 1 from the eye, for a vertical field of view in radians and the ratio of
// width to height. Throws std::domain_error unless 0 < vertical_fov < pi and
// 0 < aspect_ratio < infinity.
inline Viewport viewport_size(Real vertical_fov, Real aspect_ratio) {
    // A comparison with NaN is false; in this form, NaN throws, too.
    if (!(0 < vertical_fov && vertical_fov < pi))
        throw std::domain_error("the field of view must lie between 0 and 180 degrees");
    if (!(0 < aspect_ratio && aspect_ratio < infinity))
        throw std::domain_error("the aspect ratio must be greater than 0 and finite");
    // Like std::tan, but with the same bits whatever the library.
    const Real height = 2 * portable::tan(vertical_fov / 2);
    return {height * aspect_ratio, height};
}

}  // namespace rt
