#pragma once
#include <rt/dot.hpp>
#include <rt/hit.hpp>

namespace rt {

inline Vec3 leave_surface(const Hit& hit, Vec3 direction) {
    const Vec3 side = dot(direction, hit.normal) < 0 ? -hit.normal : hit.normal;
    return hit.point + 2 * hit.point_error * side;
}

}  // namespace rt
