#pragma once
#include <algorithm>
#include <rt/dot.hpp>

namespace rt {

// The fraction of the light from a distant lamp that a surface gets: the cosine of the angle
// between the surface's normal and the direction to the light, and 0 where the surface faces away.
// Both vectors must have length 1. Source: Lambert, "Photometria", 1760.
inline Real lambert(Vec3 normal, Vec3 to_light) {
    return std::max(Real(0), dot(normal, to_light));
}

}  // namespace rt
