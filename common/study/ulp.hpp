#pragma once
#include <cmath>
#include <limits>
#include <study/double_double.hpp>

namespace study {

// One unit in the last place of x: the distance between the numbers of type T next to x. For zero
// and the smallest numbers, it is the smallest number greater than 0; for infinity, it is the unit
// of the largest finite number.
template <class T>
T ulp(T x) {
    constexpr T largest = std::numeric_limits<T>::max();
    x = std::abs(x);
    if (x >= largest) return largest - std::nextafter(largest, T(0));
    return std::nextafter(x, largest) - x;
}

// How far the computed value is from the exact one, in units in the last place of the exact value.
// Infinite where the computed value is not finite.
template <class T>
double error_in_ulp(T computed, DoubleDouble exact) {
    if (!std::isfinite(computed)) return std::numeric_limits<double>::infinity();
    const DoubleDouble difference = exact - DoubleDouble(static_cast<double>(computed));
    return std::abs(difference.high) / static_cast<double>(ulp(static_cast<T>(exact.high)));
}

}  // namespace study
