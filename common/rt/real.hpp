#pragma once
#include <cmath>
#include <limits>
#include <numbers>

// With -ffast-math and its parts, the compiler assumes that no number is infinite or NaN, and
// removes the tests that keep NaN out of images. One study shows what else -ffast-math does.
#if (defined(__FAST_MATH__) || __FINITE_MATH_ONLY__) && !defined(RT_STUDIES_FAST_MATH)
#error the course cannot be compiled with -ffast-math, -Ofast or -ffinite-math-only: take it out of CXXFLAGS
#endif

// The build may choose the precision: -DRT_REAL=float. The default is double.
#ifndef RT_REAL
#define RT_REAL double
#endif

namespace rt {

// The number type of the whole course.
using Real = RT_REAL;

inline constexpr Real pi = std::numbers::pi_v<Real>;
inline constexpr Real infinity = std::numeric_limits<Real>::infinity();

// The distance from 1 to the next larger number: 2^-23 for float, 2^-52 for double.
inline constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

// Converts degrees to radians. All other functions take angles in radians.
constexpr Real radians(Real degrees) {
    return degrees * (pi / 180);
}

// A bound on the relative error that n rounding operations in a row can build up:
// n u / (1 - n u), where u = epsilon / 2 is the largest relative error of one rounding.
// Source: Higham, "Accuracy and Stability of Numerical Algorithms", 2nd ed., lemma 3.1.
constexpr Real rounding_bound(int n) {
    const Real nu = static_cast<Real>(n) * epsilon / 2;
    return nu / (1 - nu);
}

// a*b - c*d with an error of at most 1.5 units in the last place, even where the two products
// almost cancel. std::fma rounds once, so it recovers the rounding error of c*d exactly.
// The products themselves must neither overflow nor underflow.
// Source: Kahan's algorithm; bound by Jeannerod, Louvet and Muller, Math. Comp. 82 (2013).
inline Real difference_of_products(Real a, Real b, Real c, Real d) {
    const Real cd = c * d;
    const Real error_of_cd = std::fma(c, d, -cd);
    return std::fma(a, b, -cd) - error_of_cd;
}

}  // namespace rt
