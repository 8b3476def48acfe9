#pragma once
#include <algorithm>
#include <rt/box.hpp>
#include <rt/slab_ray.hpp>
#include <rt/sphere.hpp>

namespace rt {

// The box around a sphere, grown by hit_margin times the largest coordinate in it, so that no
// rounding of the tests lets a ray hit the sphere and miss the box.
inline Box bounds_of(const Sphere& sphere) {
    const Real margin = hit_margin * (max_component(sphere.center) + sphere.radius);
    const Real reach = sphere.radius + margin;
    const Vec3 half{reach, reach, reach};
    return {sphere.center - half, sphere.center + half};
}

// The smallest box that contains both: their union. ("union" itself is a keyword of C++.)
inline Box join(const Box& a, const Box& b) {
    return {
        {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
        {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

}  // namespace rt
