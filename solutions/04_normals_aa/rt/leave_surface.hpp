#pragma once
#include <rt/dot.hpp>
#include <rt/hit.hpp>

namespace rt {

// Where a ray that leaves a surface in this direction starts: off the surface, on the side to which
// the direction points, by no more than rounding makes necessary. From there hit_sphere does not
// find the surface again, whatever its size and place, as long as the radius is 2 units in the last
// place of the center or more. A ray that goes into the sphere starts inside and meets its far side
// where the radius times the cosine of direction and normal is 8 such units or more; in a smaller
// sphere it may start outside. Source of the idea: Pharr, Jakob and Humphreys, "Physically
// Based Rendering", section 6.8.
inline Vec3 leave_surface(const Hit& hit, Vec3 direction) {
    const Vec3 side = dot(direction, hit.normal) < 0 ? -hit.normal : hit.normal;
    // The sum below rounds each coordinate once more: that is made up for in advance.
    const Real distance = hit.point_error + rounding_bound(1) * dot(abs(hit.point), abs(side));
    return hit.point + distance * side;
}

}  // namespace rt
