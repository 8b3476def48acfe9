#pragma once
#include <cmath>
#include <rt/camera.hpp>
#include <rt/todo.hpp>
#include <stdexcept>

namespace rt {

// Exercise 02.2. The viewport at distance 1 from the eye, for a vertical field of view in
// radians and the ratio of width to height. The text derives the formula from a right triangle.
// Star: throws std::domain_error unless 0 < vertical_fov < pi and 0 < aspect_ratio < infinity; NaN
// throws, too. The height is within 4 units in the last place, the width within 9, for every valid
// angle and ratio.
inline Viewport viewport_size(Real vertical_fov, Real aspect_ratio) {
    return rt::todo("02.2", vertical_fov, aspect_ratio);
}

}  // namespace rt
