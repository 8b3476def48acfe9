#pragma once
#include <rt/dot.hpp>
#include <rt/hit.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 04.6. The starting point of a ray that leaves a surface in this direction. It is moved
// off the surface, along the normal, to the side that the direction points to. The distance is at
// least point_error and less than four times as much.
// Star: from there hit_sphere does not find the surface again, whatever its size and position, as
// long as the radius is at least 2 units in the last place of the center. For a ray that goes into
// the sphere, let c be the cosine of the angle between the ray and the inward normal. If the radius
// times c is at least 8 such units, the ray starts inside and meets the far side; otherwise it may
// start outside. Source of the idea: Pharr, Jakob and Humphreys, "Physically Based Rendering",
// section 6.8.
inline Vec3 leave_surface(const Hit& hit, Vec3 direction) {
    return rt::todo("04.6", hit, direction);
}

}  // namespace rt
