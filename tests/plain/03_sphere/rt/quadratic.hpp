#pragma once
#include <cmath>
#include <optional>
#include <rt/real.hpp>
#include <rt/roots.hpp>
#include <utility>

namespace rt {

inline std::optional<Roots> roots_from_discriminant(Real a, Real b, [[maybe_unused]] Real c,
                                                    Real discriminant) {
    if (discriminant < 0) return {};
    const Real root = std::sqrt(discriminant);
    const Real one = (-b - root) / (2 * a), other = (-b + root) / (2 * a);
    return one < other ? Roots{one, other} : Roots{other, one};
}

inline std::optional<Roots> solve_quadratic(Real a, Real b, Real c) {
    return roots_from_discriminant(a, b, c, b * b - 4 * a * c);
}

}  // namespace rt
