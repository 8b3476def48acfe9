#pragma once
#include <rt/dot.hpp>
#include <rt/hit.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 04.6. Where a ray that leaves a surface in this direction starts: off the surface, on
// the side to which the direction points, along the normal, by point_error or a bit more: what
// rounding makes necessary, and never four times as much. From there hit_sphere does not find the
// surface again, whatever its size and place, as long as the radius is 2 units in the last place of
// the center or more. A ray that goes into the sphere starts inside and meets its far side where
// the radius times the cosine of direction and normal is 8 such units or more; in a smaller sphere
// it may start outside. Source of the idea: Pharr, Jakob and Humphreys, "Physically Based
// Rendering", section 6.8.
inline Vec3 leave_surface(const Hit& hit, Vec3 direction) {
    return rt::todo("04.6", hit, direction);
}

}  // namespace rt
