#include <rt/gradient.hpp>

namespace rt {

// mix(a, b, t) is (1 - t) a + t b. The shorter a + t (b - a) would miss b by a rounding at t = 1.
Color gradient(const Corners& corners, Real across, Real down) {
    const Color top = mix(corners.top_left, corners.top_right, across);
    const Color bottom = mix(corners.bottom_left, corners.bottom_right, across);
    return mix(top, bottom, down);
}

}  // namespace rt
