#pragma once
#include <cmath>
#include <rt/box.hpp>
#include <rt/interval.hpp>
#include <rt/slab_ray.hpp>

namespace rt {

// The part of the interval in which the ray is in the box, grown by ray.margin on all sides. If the
// ray misses the box, or if the box or the interval is empty, the part is empty: min > max. Faces,
// edges and corners belong to the box, and a ray that runs within a face meets it. The box may also
// be eight boxes side by side, whose planes are packs; then so are the ends of the interval.
// Source of the idea: Kay and Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986.
template <class AnyBox, class AnyRay, class AnyInterval>
inline AnyInterval hit_box(const AnyBox& box, const AnyRay& ray, AnyInterval within) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto origin = along(ray.origin, axis), inverse = along(ray.inverse, axis);
        const auto low = along(box.low, axis) - ray.margin;
        const auto high = along(box.high, axis) + ray.margin;
        // A ray along -x meets the higher plane first.
        const bool forward = !std::signbit(inverse);
        const auto enters = ((forward ? low : high) - origin) * inverse;
        const auto leaves = ((forward ? high : low) - origin) * inverse;
        // For a ray in a face of the box, 0 * infinity is NaN. max and min then return their first
        // argument, so this plane does not count.
        within.min = max(within.min, enters);
        within.max = min(within.max, leaves);
    }
    return within;
}

}  // namespace rt
