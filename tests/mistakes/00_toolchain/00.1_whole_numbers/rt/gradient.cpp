#include <rt/gradient.hpp>

namespace rt {

Color gradient(const Corners& corners, Real across, Real down) {
    const int column = static_cast<int>(across), row = static_cast<int>(down);
    const Color top = mix(corners.top_left, corners.top_right, static_cast<Real>(column));
    const Color bottom = mix(corners.bottom_left, corners.bottom_right, static_cast<Real>(column));
    return mix(top, bottom, static_cast<Real>(row));
}

}  // namespace rt
