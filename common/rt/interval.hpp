#pragma once
#include <algorithm>
#include <rt/real.hpp>

namespace rt {

// The numbers from min to max. It is empty when min > max.
struct Interval {
    Real min = 0, max = infinity;

    // Both ends belong to the interval. False for NaN.
    constexpr bool contains(Real x) const { return min <= x && x <= max; }
    constexpr bool is_empty() const { return min > max; }
    constexpr Real size() const { return is_empty() ? 0 : max - min; }
    // The nearest number within the interval, which must not be empty.
    constexpr Real clamp(Real x) const { return std::clamp(x, min, max); }

    friend constexpr bool operator==(const Interval&, const Interval&) = default;
};

}  // namespace rt
