#include <rt/gradient.hpp>

namespace rt {

Color gradient(const Corners& corners, Real across, Real down) {
    const Color top = mix(corners.top_left, corners.top_right, across);
    const Color bottom = mix(corners.bottom_left, corners.bottom_right, across);
    return mix(bottom, top, down);
}

}  // namespace rt
