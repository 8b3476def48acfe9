#pragma once
#include <cmath>
#include <rt/box.hpp>
#include <rt/interval.hpp>
#include <rt/slab_ray.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 07.1. The part of the interval in which the ray is in the box, grown by ray.margin on
// all sides. If the ray misses the box, the part is empty: min > max. The box may be a Box or eight
// boxes at once. So write auto for the type of a number, and max(a, b) and min(a, b) without std::.
// Source of the idea: Kay and Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986.
// Star: faces, edges and corners belong to the box, and a ray that runs within a face meets it. A
// component of the direction may be 0 or -0: then ray.inverse has infinity or -infinity there. The
// margin covers all rounding: add no other tolerance. The part is always empty for the empty box,
// Box{}, and for an empty interval (min > max).
template <class AnyBox, class AnyRay, class AnyInterval>
inline AnyInterval hit_box(const AnyBox& box, const AnyRay& ray, AnyInterval within) {
    return rt::todo("07.1", box, ray, within);
}

}  // namespace rt
