#pragma once
#include <algorithm>
#include <cmath>
#include <rt/dot.hpp>

namespace rt {

inline Real lambert(Vec3 normal, Vec3 to_light) {
    return std::max(Real(0), 1 - 2 / pi * std::acos(dot(normal, to_light)));
}

}  // namespace rt
