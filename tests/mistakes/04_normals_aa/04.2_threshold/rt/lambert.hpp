#pragma once
#include <algorithm>
#include <rt/dot.hpp>

namespace rt {

inline Real lambert(Vec3 normal, Vec3 to_light) {
    const Real cosine = dot(normal, to_light);
    return cosine > Real(1e-4) ? cosine : 0;
}

}  // namespace rt
