#pragma once
#include <algorithm>
#include <rt/box.hpp>
#include <rt/sphere.hpp>

namespace rt {

inline Box bounds_of(const Sphere& sphere) {
    const Vec3 half{sphere.radius, sphere.radius, sphere.radius};
    return {sphere.center - half, sphere.center + half};
}

inline Box join(const Box& a, const Box& b) {
    return {
        {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
        {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

}  // namespace rt
