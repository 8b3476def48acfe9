#include <rt/gradient.hpp>

namespace rt {

Color gradient(const Corners& corners, Real across, Real down) {
    return mix(corners.top_left, corners.bottom_right, (across + down) / 2);
}

}  // namespace rt
