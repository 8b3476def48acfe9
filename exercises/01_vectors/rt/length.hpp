#pragma once
#include <cmath>
#include <rt/dot.hpp>
#include <rt/todo.hpp>
#include <rt/vec3.hpp>
#include <stdexcept>

namespace rt {

// Exercise 01.4. The length of v.
// Star: of any finite v, within 2.5 units in the last place, and infinite only where the true
// length exceeds the largest number. Given for both functions, in <rt/vec3.hpp>: is_finite(v) and
// split_scale(v). The latter's result, `scaled`, has a vector scaled.v, whose largest component is
// near 1, and a whole number scaled.exponent: v is exactly scaled.v * 2^scaled.exponent.
// std::scalbn(x, n) is x * 2^n.
inline Real length(Vec3 v) {
    return rt::todo("01.4", v);
}

// Exercise 01.4. The vector of length 1 in the direction of v.
// Star: of any finite v but zero, each component within 3.5 units in the last place. Throws
// std::domain_error if v is zero or not finite: then it has no direction.
inline Vec3 normalize(Vec3 v) {
    return rt::todo("01.4", v);
}

}  // namespace rt
