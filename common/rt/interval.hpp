#pragma once
#include <algorithm>
#include <rt/real.hpp>

namespace rt {

// All numbers from min to max. The interval is empty if min > max.
struct Interval {
    Real min = 0, max = infinity;

    // Both ends belong to the interval. False for NaN.
    constexpr bool contains(Real x) const { return min <= x && x <= max; }
    constexpr bool is_empty() const { return min > max; }
    constexpr Real size() const { return is_empty() ? 0 : max - min; }
    // The number in the interval that is nearest to x. The interval must not be empty.
    constexpr Real clamp(Real x) const { return std::clamp(x, min, max); }

    friend constexpr bool operator==(const Interval&, const Interval&) = default;
};

}  // namespace rt
