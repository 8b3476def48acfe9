#pragma once
#include <algorithm>
#include <cmath>
#include <rt/box.hpp>
#include <rt/interval.hpp>
#include <rt/slab_ray.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 07.1. True if the ray meets the box, grown by ray.margin on all sides, at some t of the
// interval. Source of the idea: Kay and Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986.
// Star: faces, edges and corners belong to the box, and a ray that runs within a face meets it. A
// component of the direction may be 0 or -0: then ray.inverse has infinity or -infinity there. The
// margin covers all rounding: add no other tolerance. The result is always false for the empty box,
// Box{}, and for an empty interval (min > max).
inline bool hit_box(const Box& box, const SlabRay& ray, Interval within) {
    return rt::todo("07.1", box, ray, within);
}

}  // namespace rt
