#pragma once
#include <rt/dot.hpp>
#include <rt/hit.hpp>

namespace rt {

inline Vec3 leave_surface(const Hit& hit, Vec3 direction) {
    const Vec3 side = dot(direction, hit.normal) < 0 ? -hit.normal : hit.normal;
    const Real distance = hit.point_error;
    return hit.point + distance * side;
}

}  // namespace rt
