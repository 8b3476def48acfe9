#pragma once
#include <rt/dot.hpp>
#include <rt/hit.hpp>

namespace rt {

inline Vec3 leave_surface(const Hit& hit, Vec3 direction) {
    const Vec3 side = dot(direction, hit.normal) < 0 ? -hit.normal : hit.normal;
    const Real distance = hit.point_error + rounding_bound(1) * dot(abs(hit.point), abs(side));
    return hit.point + 100 * distance * side;
}

}  // namespace rt
