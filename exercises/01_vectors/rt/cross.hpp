#pragma once
#include <rt/todo.hpp>
#include <rt/vec3.hpp>

namespace rt {

// Exercise 01.3. The cross product: perpendicular to a and b, of length |a| |b| times the sine of
// the angle between them, along the thumb of the right hand when its fingers curl from a to b.
// Star: each component is within 1.5 units in the last place, however nearly parallel a and b are,
// as long as no product overflows or underflows. Use difference_of_products(p, q, r, s) from
// <rt/real.hpp>, which is p q - r s.
inline Vec3 cross(Vec3 a, Vec3 b) {
    return rt::todo("01.3", a, b);
}

}  // namespace rt
