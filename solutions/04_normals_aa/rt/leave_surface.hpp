#pragma once
#include <rt/dot.hpp>
#include <rt/hit.hpp>

namespace rt {

// The starting point of a ray that leaves a surface in this direction. It is off the surface, on
// the side that the direction points to, by no more than rounding makes necessary. From there
// hit_sphere does not find the surface again, whatever its size and position, as long as the radius
// is at least 2 units in the last place of the center. A ray that goes into the sphere starts
// inside and meets its far side if the radius times the cosine of the angle between direction and
// inward normal is at least 8 such units; in a smaller sphere it may start outside. Source of the
// idea: Pharr, Jakob and Humphreys, "Physically Based Rendering", section 6.8.
inline Vec3 leave_surface(const Hit& hit, Vec3 direction) {
    const Vec3 side = dot(direction, hit.normal) < 0 ? -hit.normal : hit.normal;
    // The sum below rounds each coordinate once more: the distance makes up for that in advance.
    const Real distance = hit.point_error + rounding_bound(1) * dot(abs(hit.point), abs(side));
    return hit.point + distance * side;
}

}  // namespace rt
