#pragma once
#include <cmath>
#include <optional>
#include <rt/real.hpp>
#include <rt/roots.hpp>
#include <rt/todo.hpp>
#include <utility>

namespace rt {

// Exercise 03.1. The real solutions of a t^2 + b t + c = 0, given its discriminant b^2 - 4 a c,
// which each caller computes in its own way. Return {} (no solution) if the discriminant is
// negative. If it is 0, the one solution is both low and high.
// Star: return {} if the discriminant is NaN, and if a and b are both 0. If a = 0, the one solution
// is both low and high. Each solution is accurate to 4 units in the last place if the discriminant
// is exact.
// Source: Higham, "Accuracy and Stability of Numerical Algorithms", 2nd ed., section 1.8.
inline std::optional<Roots> roots_from_discriminant(Real a, Real b, Real c, Real discriminant) {
    return rt::todo("03.1", a, b, c, discriminant);
}

// Exercise 03.1. The real solutions of a t^2 + b t + c = 0.
// Star: each solution is accurate to 4 units in the last place. You may assume that b^2, 4 a c and
// their difference do not overflow, and that b^2 and 4 a c are each either 0 or at least 10^-275 in
// size (float: 10^-23). rt::difference_of_products(p, q, r, s), given in rt/real.hpp, is p q - r s
// without cancellation.
inline std::optional<Roots> solve_quadratic(Real a, Real b, Real c) {
    return rt::todo("03.1", a, b, c);
}

}  // namespace rt
