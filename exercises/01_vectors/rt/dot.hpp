#pragma once
#include <rt/todo.hpp>
#include <rt/vec3.hpp>

namespace rt {

// Exercise 01.2. The dot product: |a| |b| times the cosine of the angle between a and b.
// Star: the rounding error is at most `rounding_bound(3) * (|ax bx| + |ay by| + |az bz|)`.
inline Real dot(Vec3 a, Vec3 b) {
    return rt::todo("01.2", a, b);
}

}  // namespace rt
