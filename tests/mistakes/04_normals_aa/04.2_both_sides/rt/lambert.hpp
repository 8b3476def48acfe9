#pragma once
#include <cmath>
#include <rt/dot.hpp>

namespace rt {

inline Real lambert(Vec3 normal, Vec3 to_light) {
    return std::abs(dot(normal, to_light));
}

}  // namespace rt
