#pragma once
#include <cmath>
#include <limits>
#include <rt/real.hpp>

namespace checkpoint {

// What a hint says if only_single_precision().
inline constexpr const char* single_precision_hint =
    "only the first seven digits are right. A Real has more: a step on the way is a `float`, by "
    "its "
    "type or by a constant such as 0.1f";

// Whether a wrong number has the digits of a float, no more and hardly less, where Real is wider.
inline bool only_single_precision(long double actual, long double expected) {
    constexpr auto single = static_cast<long double>(std::numeric_limits<float>::epsilon());
    const long double error = std::abs(actual - expected);
    return std::numeric_limits<rt::Real>::digits > std::numeric_limits<float>::digits &&
           error <= 8 * single * std::abs(expected) && error > single / 1024 * std::abs(expected);
}

}  // namespace checkpoint
