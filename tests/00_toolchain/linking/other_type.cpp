// Not the function that was declared: its numbers have another type.
#include <rt/gradient.hpp>

namespace rt {

Color gradient(const Corners& corners, long double, long double) {
    return corners.top_left;
}

}  // namespace rt
