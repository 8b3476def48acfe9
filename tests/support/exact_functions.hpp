#pragma once
// Sines, cosines, tangents and roots in twice the precision of double: exact values for the
// checkpoints. tests/common/exact_functions.cpp compares them with a table.

#include <cmath>
#include <study/double_double.hpp>

#include "checkpoint.hpp"

namespace checkpoint {

inline constexpr Exact exact_pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

struct ExactSineCosine {
    Exact sine, cosine;
};

// Of an angle from -1 to 1, in radians: the Taylor series of both.
inline ExactSineCosine exact_sine_cosine(Exact angle) {
    Exact sums[2], term = 1;
    for (int n = 0; n < 32; ++n) {
        sums[n % 2] = sums[n % 2] + (n % 4 < 2 ? term : -term);
        term = term * angle / Exact(n + 1);
    }
    return {sums[1], sums[0]};
}

// Of a part of a whole turn, from 0 to 1: taken from the nearest quarter, where one of them is 0.
inline ExactSineCosine exact_sine_cosine_of_turn(double turn) {
    const double quarter = std::round(4 * turn);
    const Exact rest = Exact(turn) - Exact(quarter / 4);
    ExactSineCosine both = exact_sine_cosine(Exact(2) * exact_pi * rest);
    for (int i = 0; i < quarter; ++i) both = {both.cosine, -both.sine};
    return both;
}

// The tangent of half an angle between 0 and pi. Above a right angle it is the cosine divided by
// the sine of what is left to pi.
inline Exact exact_tangent_of_half(double angle) {
    const bool wide = angle > 1.6;
    const auto [sine, cosine] =
        exact_sine_cosine((wide ? exact_pi - Exact(angle) : Exact(angle)) * Exact(0.5));
    return wide ? cosine / sine : sine / cosine;
}

inline Exact exact_power(Exact x, int n) {
    Exact power = 1;
    for (int i = 0; i < n; ++i) power = power * x;
    return power;
}

// The n-th root of x >= 0: a step of Newton's method from the root in double.
inline Exact exact_root(Exact x, int n) {
    if (!(x.high > 0)) return {};
    const Exact root = std::pow(x.high, 1.0 / n);
    return root - (exact_power(root, n) - x) / (Exact(n) * exact_power(root, n - 1));
}

}  // namespace checkpoint
