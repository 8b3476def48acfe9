#include <rt/gradient.hpp>

namespace rt {

// mix(a, b, t) is (1 - t) a + t b. At t = 1, the shorter a + t (b - a) could miss b by a rounding
// error.
Color gradient(const Corners& corners, Real across, Real down) {
    const Color top = mix(corners.top_left, corners.top_right, across);
    const Color bottom = mix(corners.bottom_left, corners.bottom_right, across);
    return mix(top, bottom, down);
}

}  // namespace rt
