#pragma once
#include <cmath>
#include <rt/dot.hpp>
#include <rt/todo.hpp>
#include <rt/vec3.hpp>
#include <stdexcept>

namespace rt {

// Exercise 01.4. The length of v.
// Star: for any finite v, the result is within 2.5 units in the last place, and infinite only if
// the true length exceeds the largest number. For this function and normalize, <rt/vec3.hpp>
// provides is_finite(v) and split_scale(v). Let `scaled` be the result of split_scale(v): the
// largest component of scaled.v is near 1, scaled.exponent is a whole number, and v is exactly
// scaled.v * 2^scaled.exponent. std::scalbn(x, n) is x * 2^n.
inline Real length(Vec3 v) {
    return rt::todo("01.4", v);
}

// Exercise 01.4. The vector of length 1 in the direction of v.
// Star: for any finite v except zero, each component is within 3.5 units in the last place. Throws
// std::domain_error if v is zero or not finite, because v then has no direction.
inline Vec3 normalize(Vec3 v) {
    return rt::todo("01.4", v);
}

}  // namespace rt
