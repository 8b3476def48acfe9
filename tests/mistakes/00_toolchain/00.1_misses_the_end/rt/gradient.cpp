#include <rt/gradient.hpp>

namespace rt {

Color gradient(const Corners& corners, Real across, Real down) {
    const Color top = corners.top_left + across * (corners.top_right - corners.top_left);
    const Color bottom =
        corners.bottom_left + across * (corners.bottom_right - corners.bottom_left);
    return top + down * (bottom - top);
}

}  // namespace rt
