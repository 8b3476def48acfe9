#pragma once
#include <cmath>
#include <optional>
#include <rt/real.hpp>
#include <rt/roots.hpp>
#include <utility>

namespace rt {

inline std::optional<Roots> roots_from_discriminant(Real a, Real b, Real c, Real discriminant) {
    if (!(discriminant >= 0)) return {};
    const Real q = -(b + static_cast<Real>((b > 0) - (b < 0)) * std::sqrt(discriminant)) / 2;
    if (q == 0) {
        if (a == 0) return {};
        return Roots{0, 0};
    }
    const Real one = c / q;
    const Real other = a == 0 ? one : q / a;
    return one < other ? Roots{one, other} : Roots{other, one};
}

inline std::optional<Roots> solve_quadratic(Real a, Real b, Real c) {
    return roots_from_discriminant(a, b, c, difference_of_products(b, b, 4 * a, c));
}

}  // namespace rt
