#pragma once
#include <cmath>
#include <optional>
#include <rt/real.hpp>
#include <rt/roots.hpp>
#include <utility>

namespace rt {

inline std::optional<Roots> roots_from_discriminant(Real a, Real b, Real c, Real discriminant) {
    if (!(discriminant >= 0)) return {};
    const Real q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
    if (std::abs(q) < Real(1e-12)) {  // b = 0 and the discriminant is 0
        if (std::abs(a) < Real(1e-12)) return {};
        return Roots{0, 0};
    }
    const Real one = c / q;  // the product of the solutions is c / a
    const Real other = std::abs(a) < Real(1e-12) ? one : q / a;
    return one < other ? Roots{one, other} : Roots{other, one};
}

inline std::optional<Roots> solve_quadratic(Real a, Real b, Real c) {
    return roots_from_discriminant(a, b, c, difference_of_products(b, b, 4 * a, c));
}

}  // namespace rt
