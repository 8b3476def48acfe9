#pragma once
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
    const auto beyond = refracted_cosine(cosine, eta);
    if (!beyond) return 1;
    const Real r_s = (eta * cosine - *beyond) / (eta * cosine + *beyond);
    const Real r_p = (cosine - eta * *beyond) / (cosine + eta * *beyond);
    return (r_s * r_s + r_p * r_p) / 2;
}
inline Real schlick_reflectance(Real cosine, Real eta) {
    if (eta > 1) {
        const auto beyond = refracted_cosine(cosine, eta);
        if (!beyond) return 1;
        cosine = *beyond;
    }
    const Real r = (1 - eta) / (1 + eta);
    return r * r + (1 - r * r) * std::pow(1 - cosine, Real(5));
}
}  // namespace rt
