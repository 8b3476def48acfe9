#pragma once
// The tools of the checkpoints: Catch2, exact values, and errors in units in the last place.

#include "catch.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <rt/real.hpp>
#include <rt/vec3_of.hpp>
#include <rt/vec3_type.hpp>
#include <string>
#include <study/double_double.hpp>
#include <study/ulp.hpp>
#include <type_traits>

namespace checkpoint {

using rt::Real;
using rt::Vec3;

// An exact value, correct to about 98 bits. Numbers so large or small that their products overflow
// or underflow are scaled by a power of two first.
using Exact = study::DoubleDouble;

using ExactVec3 = rt::Vec3Of<Exact>;

// Picks the value for the precision that is tested.
template <class T>
constexpr T for_this_precision(T in_float, T in_double) {
    return std::is_same_v<Real, float> ? in_float : in_double;
}

// A number in the precision that is tested.
constexpr Real real(double value) {
    return static_cast<Real>(value);
}

// The largest error of a computed vector's components, in units in the last place.
inline double error_in_ulp(Vec3 computed, const ExactVec3& exact) {
    return std::max({study::error_in_ulp(computed.x, exact.x),
                     study::error_in_ulp(computed.y, exact.y),
                     study::error_in_ulp(computed.z, exact.z)});
}
using study::error_in_ulp;

// Numbers with all their digits, for messages.
inline std::string text(Real value) {
    char buffer[64];
    const std::to_chars_result written =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general,
                      std::numeric_limits<Real>::max_digits10);
    return {buffer, written.ptr};
}
inline std::string text(Vec3 v) {
    return '(' + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ')';
}
inline std::string text(const Exact& value) {
    return text(static_cast<Real>(value.high));
}
inline std::string text(const ExactVec3& v) {
    return '(' + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ')';
}

}  // namespace checkpoint

// A line of a failing checkpoint's message that is put together only when it is needed: what was
// computed, what was expected, what that suggests.
#define HINT(expected, computed, suggestion)                                                 \
    INFO(EXPECTED << checkpoint::text(expected) << ", " ACTUAL << checkpoint::text(computed) \
                  << ".\nHint: " << (suggestion))

// The same for the next assertion alone, which may stand after the block that this stands in.
#define UNSCOPED_HINT(expected, computed, suggestion)                   \
    UNSCOPED_INFO(EXPECTED << checkpoint::text(expected) << ", " ACTUAL \
                           << checkpoint::text(computed) << ".\nHint: " << (suggestion))
