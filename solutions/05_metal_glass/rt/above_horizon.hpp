#pragma once
#include <algorithm>
#include <cmath>
#include <rt/length.hpp>

namespace rt {

// The direction of v, folded to the normal's side of the surface: if v points below, it is mirrored
// at the surface. v may have any length that is far from the smallest and the largest numbers; the
// result has length 1, and its computed dot product with the normal is greater than 0, whatever was
// rounded. A zero v has no direction, so it gives the normal.
inline Vec3 above_horizon(Vec3 v, Vec3 normal) {
    if (v == Vec3{}) return normal;
    const Real height = dot(v, normal);
    // The height rounds 3 times, its correction once, the division of normalize once, and the
    // caller's dot product 3 times. Twice these 8 leave no doubt; the sum is at least v's length.
    const Real least = rounding_bound(16) * (std::abs(v.x) + std::abs(v.y) + std::abs(v.z));
    return normalize(v + (std::max(std::abs(height), least) - height) * normal);
}

}  // namespace rt
