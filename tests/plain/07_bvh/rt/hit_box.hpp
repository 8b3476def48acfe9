#pragma once
#include <rt/box.hpp>
#include <rt/interval.hpp>
#include <rt/slab_ray.hpp>
#include <utility>

namespace rt {
template <class AnyBox, class AnyRay, class AnyInterval>
inline AnyInterval hit_box(const AnyBox& box, const AnyRay& ray, AnyInterval within) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto inverse = along(ray.inverse, axis), o = along(ray.origin, axis);
        auto enter = (along(box.low, axis) - ray.margin - o) * inverse;
        auto leave = (along(box.high, axis) + ray.margin - o) * inverse;
        if (inverse < 0) std::swap(enter, leave);
        within.min = max(enter, within.min);
        within.max = min(leave, within.max);
    }
    return within;
}
}  // namespace rt
