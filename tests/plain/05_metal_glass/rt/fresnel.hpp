#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <rt/real.hpp>

namespace rt {

inline std::optional<Real> refracted_cosine(Real cosine, Real eta) {
    const Real squared = 1 - eta * eta * (1 - cosine * cosine);
    if (squared < 0) return {};
    return std::sqrt(squared);
}

inline Real fresnel_reflectance(Real cosine, Real eta) {
    const std::optional<Real> beyond = refracted_cosine(cosine, eta);
    if (!beyond) return 1;
    const Real s = (eta * cosine - *beyond) / (eta * cosine + *beyond);
    const Real p = (eta * *beyond - cosine) / (eta * *beyond + cosine);
    return (s * s + p * p) / 2;
}

inline Real schlick_reflectance(Real cosine, Real eta) {
    if (eta > 1) {
        const std::optional<Real> beyond = refracted_cosine(cosine, eta);
        if (!beyond) return 1;
        cosine = *beyond;
    }
    const Real r = (1 - eta) / (1 + eta);
    const Real head_on = r * r;
    const Real x = 1 - cosine;
    return head_on + (1 - head_on) * x * x * x * x * x;
}

}  // namespace rt
