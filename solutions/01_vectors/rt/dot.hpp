#pragma once
#include <rt/vec3.hpp>

namespace rt {

// The dot product: |a| |b| times the cosine of the angle between a and b.
// The rounding error is at most `rounding_bound(3) * (|ax bx| + |ay by| + |az bz|)`.
inline Real dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace rt
