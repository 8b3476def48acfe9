#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <rt/real.hpp>

namespace rt {

// In all three functions, `cosine` is that of the angle between the normal and the light that
// arrives, in [0, 1] (a value that rounding has put above 1 counts as 1). eta, greater than 0, is
// the index of refraction on the side that the light comes from, divided by the index on the other
// side.

// The cosine of the refraction angle. None at total reflection.
inline std::optional<Real> refracted_cosine(Real cosine, Real eta) {
    // 1 - eta^2 (1 - cosine^2), in terms that cancel only where total reflection begins.
    const Real scaled = eta * std::min(cosine, Real(1));
    const Real squared = difference_of_products(scaled, scaled, eta - 1, eta + 1);
    if (squared < 0) return {};
    return std::sqrt(squared);
}

// The fraction of unpolarized light that is reflected, in [0, 1]. It is 0 for eta = 1, and 1 at
// total reflection. Source: Fresnel's equations; here r_s = (eta c - c') / (eta c + c') is written
// as (eta^2 - 1) / (eta c + c')^2, and r_p = r_s cos(a + a') / cos(a - a'). In this form, no
// cancellation does harm, however close together the two indices are.
inline Real fresnel_reflectance(Real cosine, Real eta) {
    if (eta == 1) return 0;
    const std::optional<Real> beyond = refracted_cosine(cosine, eta);
    if (!beyond) return 1;
    const Real c = std::min(cosine, Real(1));
    const Real sum = eta * c + *beyond;
    const Real r_s = (eta - 1) * (eta + 1) / (sum * sum);
    const Real cosines = c * *beyond, sines = eta * (1 - c) * (1 + c);
    const Real p_over_s = (cosines - sines) / (cosines + sines);
    return std::min(Real(1), r_s * r_s * (1 + p_over_s * p_over_s) / 2);
}

// The same fraction by Schlick's approximation, with the cosine on the side of the smaller index,
// so that the reflectance is the same from both sides of a surface, and 1 where total reflection
// begins.
// Source: Schlick, "An inexpensive BRDF model for physically-based rendering", 1994.
inline Real schlick_reflectance(Real cosine, Real eta) {
    if (eta > 1) {
        const std::optional<Real> beyond = refracted_cosine(cosine, eta);
        if (!beyond) return 1;
        cosine = *beyond;
    }
    const Real r = (1 - eta) / (1 + eta);
    const Real head_on = r * r;
    const Real x = 1 - std::min(cosine, Real(1));
    return head_on + (1 - head_on) * (x * x) * (x * x) * x;
}

}  // namespace rt
