#pragma once
#include <algorithm>
#include <cmath>
#include <rt/box.hpp>
#include <rt/interval.hpp>
#include <rt/slab_ray.hpp>

namespace rt {

// True when the ray meets the box, grown by ray.margin on all sides, at some t of the interval.
// Faces, edges and corners belong to the box, and a ray that runs within a face meets it. Always
// false for the empty box and for an empty interval.
// Source of the idea: Kay and Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986.
inline bool hit_box(const Box& box, const SlabRay& ray, Interval within) {
    for (int axis = 0; axis < 3; ++axis) {
        const Real origin = along(ray.origin, axis), inverse = along(ray.inverse, axis);
        const Real low = along(box.low, axis) - ray.margin;
        const Real high = along(box.high, axis) + ray.margin;
        // A ray along -x meets the higher plane first.
        const bool forward = !std::signbit(inverse);
        const Real enters = ((forward ? low : high) - origin) * inverse;
        const Real leaves = ((forward ? high : low) - origin) * inverse;
        // For a ray in a face of the box, 0 * infinity is NaN. std::max and std::min then return
        // their first argument, so this plane does not count.
        within.min = std::max(within.min, enters);
        within.max = std::min(within.max, leaves);
    }
    return within.min <= within.max;
}

}  // namespace rt
