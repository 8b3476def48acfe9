#pragma once
#include <cmath>
#include <optional>
#include <rt/real.hpp>
#include <rt/roots.hpp>
#include <utility>

namespace rt {

// The real solutions of a t^2 + b t + c = 0, given its discriminant b^2 - 4 a c, which each caller
// computes in its own way. None if the discriminant is negative, or if a and b are both 0. If a =
// 0, the one solution is both low and high.
inline std::optional<Roots> roots_from_discriminant(Real a, Real b, Real c, Real discriminant) {
    if (!(discriminant >= 0)) return {};
    // b and the root get the same sign, so that they add up and never cancel.
    const Real q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
    if (q == 0) {  // b = 0 and the discriminant is 0
        if (a == 0) return {};
        return Roots{0, 0};
    }
    const Real one = c / q;  // the product of the solutions is c / a
    const Real other = a == 0 ? one : q / a;
    return one < other ? Roots{one, other} : Roots{other, one};
}

// The real solutions of a t^2 + b t + c = 0, each accurate to 4 units in the last place. b^2, 4 a c
// and their difference must not overflow, and b^2 and 4 a c must each be 0 or at least 10^-275
// (float: 10^-23) in size.
inline std::optional<Roots> solve_quadratic(Real a, Real b, Real c) {
    // A quarter of the discriminant: 4 * a could overflow where 4 a c does not.
    const Real quarter = difference_of_products(b / 2, b / 2, a, c);
    return roots_from_discriminant(a, b, c, 4 * quarter);
}

}  // namespace rt
