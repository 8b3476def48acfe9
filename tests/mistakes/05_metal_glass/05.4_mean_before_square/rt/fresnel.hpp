#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <rt/real.hpp>

namespace rt {

inline std::optional<Real> refracted_cosine(Real cosine, Real eta) {
    const Real scaled = eta * std::min(cosine, Real(1));
    const Real squared = difference_of_products(scaled, scaled, eta - 1, eta + 1);
    if (squared < 0) return {};
    return std::sqrt(squared);
}

inline Real fresnel_reflectance(Real cosine, Real eta) {
    if (eta == 1) return 0;
    const std::optional<Real> beyond = refracted_cosine(cosine, eta);
    if (!beyond) return 1;
    const Real c = std::min(cosine, Real(1));
    const Real sum = eta * c + *beyond;
    const Real r_s = (eta - 1) * (eta + 1) / (sum * sum);
    const Real cosines = c * *beyond, sines = eta * (1 - c) * (1 + c);
    const Real p_over_s = (cosines - sines) / (cosines + sines);
    return std::min(Real(1), r_s * r_s * ((1 + p_over_s) / 2) * ((1 + p_over_s) / 2));
}

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
