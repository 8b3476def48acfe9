#pragma once
#include <rt/dot.hpp>
#include <rt/hit.hpp>

namespace rt {

inline Vec3 leave_surface(const Hit& hit, Vec3 direction) {
    [[maybe_unused]] const Vec3 side = dot(direction, hit.normal) < 0 ? -hit.normal : hit.normal;
    [[maybe_unused]] const Real distance =
        hit.point_error + rounding_bound(1) * dot(abs(hit.point), abs(side));
    return hit.point;
}

}  // namespace rt
