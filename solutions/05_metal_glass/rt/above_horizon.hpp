#pragma once
#include <algorithm>
#include <cmath>
#include <rt/length.hpp>

namespace rt {

// The direction of v, folded to the normal's side of the surface: if v points below, it is mirrored
// at the surface. v may have any length that is far from the smallest and the largest numbers; the
// result has length 1, and its computed dot product with the normal is greater than 0, whatever the
// rounding. A zero v has no direction, so it gives the normal.
inline Vec3 above_horizon(Vec3 v, Vec3 normal) {
    if (v == Vec3{}) return normal;
    const Real height = dot(v, normal);
    // There are 3 roundings in the height, 1 in its correction, 1 in the division of normalize and
    // 3 in the caller's dot product. A bound for twice these 8 leaves no doubt. The sum of the
    // absolute values is at least the length of v.
    const Real least = rounding_bound(16) * (std::abs(v.x) + std::abs(v.y) + std::abs(v.z));
    return normalize(v + (std::max(std::abs(height), least) - height) * normal);
}

}  // namespace rt
