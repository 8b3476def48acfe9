#pragma once
#include <cmath>
#include <rt/dot.hpp>
#include <rt/todo.hpp>
#include <rt/vec3.hpp>
#include <stdexcept>

namespace rt {

// Exercise 01.4. Given for both functions, in <rt/vec3.hpp>: split_scale(v), whose result `scaled`
// has a vector scaled.v with its largest component near 1 and a whole number scaled.exponent, such
// that v is exactly scaled.v * 2^scaled.exponent; and is_finite(v). std::scalbn(x, n) is x * 2^n.

// The length of v, for any finite v: within 2.5 units in the last place. It is infinite only where
// the true length exceeds the largest number.
inline Real length(Vec3 v) {
    return rt::todo("01.4", v);
}

// The vector of length 1 in the direction of v, for any finite v but zero: each component within
// 3.5 units in the last place. Throws std::domain_error for a vector that is zero or not finite: it
// has no direction.
inline Vec3 normalize(Vec3 v) {
    return rt::todo("01.4", v);
}

}  // namespace rt
