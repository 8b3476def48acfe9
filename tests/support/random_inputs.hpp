#pragma once
// Random inputs from the whole range that a contract names, and exact values for them. Seeds are
// fixed: a test that passes once passes always.

#include <rt/rng.hpp>

#include "checkpoint.hpp"

namespace checkpoint {

// A number of either sign whose size is 10^low to 10^high.
inline Real any_number(rt::Rng& rng, Real low, Real high) {
    const Real size = std::pow(Real(10), rng.uniform(low, high));
    return rng() % 2 == 0 ? size : -size;
}

// A vector whose components have sizes from 10^low to 10^high; one component in eight is 0. Half of
// the vectors have components of similar size, the others of any sizes.
inline Vec3 any_vector(rt::Rng& rng, Real low, Real high) {
    const bool alike = rng() % 2 == 0;
    const Real size = rng.uniform(low, high);
    const auto component = [&] {
        if (rng() % 8 == 0) return rng() % 2 == 0 ? Real(0) : Real(-0.0);
        return alike ? any_number(rng, std::max(low, size - 1), size) : any_number(rng, low, high);
    };
    return {component(), component(), component()};
}

inline ExactVec3 exact_vector(Vec3 v) {
    return {Exact(v.x), Exact(v.y), Exact(v.z)};
}

inline Exact exact_length(const ExactVec3& v) {
    return study::sqrt(dot(v, v));
}
inline ExactVec3 exact_unit(const ExactVec3& v) {
    return Exact(1) / exact_length(v) * v;
}

// |ax bx| + |ay by| + |az bz|: the rounding error of a sum of products is measured
// relative to this.
inline double size_of_terms(const ExactVec3& a, const ExactVec3& b) {
    return std::abs(a.x.high * b.x.high) + std::abs(a.y.high * b.y.high) +
           std::abs(a.z.high * b.z.high);
}

// A result's error divided by the allowed error: at most 1 if the result is right. An error of 0
// is always allowed.
inline double times_allowed(Real computed, Exact exact, double allowed) {
    const double error = std::abs((exact - Exact(computed)).high);
    return error == 0 ? 0 : error / allowed;
}

}  // namespace checkpoint
