#pragma once
#include <algorithm>
#include <rt/box.hpp>
#include <rt/interval.hpp>
#include <rt/slab_ray.hpp>

namespace rt {
inline bool hit_box(const Box& box, const SlabRay& ray, Interval within) {
    for (int axis = 0; axis < 3; ++axis) {
        const Real inverse = along(ray.inverse, axis), o = along(ray.origin, axis);
        Real enter = (along(box.low, axis) - ray.margin - o) * inverse;
        Real leave = (along(box.high, axis) + ray.margin - o) * inverse;
        if (inverse < 0) std::swap(enter, leave);
        if (enter > within.min) within.min = enter;
        if (leave < within.max) within.max = leave;
    }
    return within.min <= within.max;
}
}  // namespace rt
