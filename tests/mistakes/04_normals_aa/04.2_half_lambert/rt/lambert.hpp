#pragma once
#include <algorithm>
#include <rt/dot.hpp>

namespace rt {

inline Real lambert(Vec3 normal, Vec3 to_light) {
    return (1 + dot(normal, to_light)) / 2;
}

}  // namespace rt
