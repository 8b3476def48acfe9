#pragma once
#include <cmath>
#include <limits>
#include <rt/real.hpp>

namespace checkpoint {

// What a hint says if only_single_precision().
inline constexpr const char* single_precision_hint =
    "only the first seven digits are right. A Real has more: a step on the way is a `float`, by "
    "its "
    "type or by a constant such as 0.5f";

// Whether a Real has the digits of a float only, where Real is wider than that.
inline bool only_single_precision(rt::Real actual, long double expected) {
    constexpr auto single = static_cast<long double>(std::numeric_limits<float>::epsilon());
    return std::numeric_limits<rt::Real>::digits > std::numeric_limits<float>::digits &&
           std::abs(static_cast<long double>(actual) - expected) <= 8 * single * std::abs(expected);
}

}  // namespace checkpoint
