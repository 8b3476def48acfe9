#pragma once
#include <cmath>
#include <limits>
#include <rt/real.hpp>
#include <type_traits>

namespace checkpoint {

// What a hint says if only_single_precision().
inline constexpr const char* single_precision_hint =
    "only the first seven digits are right. A Real has more: an intermediate result is a `float`, "
    "by its type or by a constant such as 0.1f";

// Whether a wrong number has the digits of a float, no more and hardly fewer, where Real is wider.
template <class A, class B>
bool only_single_precision(A actual, B expected) {
    if constexpr (std::is_same_v<rt::Real, float>) return false;
    const auto right = static_cast<long double>(expected);
    const auto single = static_cast<long double>(std::numeric_limits<float>::epsilon());
    const long double error = std::abs(static_cast<long double>(actual) - right);
    return single / 1024 * std::abs(right) < error && error <= 8 * single * std::abs(right);
}

}  // namespace checkpoint
