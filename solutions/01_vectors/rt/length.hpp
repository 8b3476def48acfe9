#pragma once
#include <cmath>
#include <rt/compiler.hpp>
#include <rt/dot.hpp>
#include <rt/interval.hpp>
#include <rt/vec3.hpp>
#include <stdexcept>

namespace rt {

// Squared lengths in this interval have neither overflowed nor lost digits: if the square of a
// component underflows, its error relative to the sum is below epsilon^2.
inline constexpr Interval safe_squares{std::numeric_limits<Real>::min() / epsilon,
                                       std::numeric_limits<Real>::max()};

// The length of v, for any finite v, accurate to 2.5 units in the last place. It is infinite only
// where the true length exceeds the largest number.
inline Real length(Vec3 v) {
    const Real squared = dot(v, v);
    if (safe_squares.contains(squared)) return std::sqrt(squared);
    // In rare cases the vector must be scaled before it is squared.
    const ScaledVec3 scaled = split_scale(v);
    return std::scalbn(std::sqrt(dot(scaled.v, scaled.v)), scaled.exponent);
}

// What normalize does if squares overflow or lose digits. This is rare; the code is separate so
// that normalize itself stays small.
RT_NOT_INLINED inline Vec3 normalize_scaled(Vec3 v) {
    const Vec3 scaled = split_scale(v).v;
    const Real squared = dot(scaled, scaled);
    if (!safe_squares.contains(squared))
        throw std::domain_error("normalize: a vector that is zero or not finite has no direction");
    return scaled / std::sqrt(squared);
}

// The vector of length 1 in the direction of v, for any finite v except zero. Each component is
// accurate to 3.5 units in the last place. Throws std::domain_error if v is zero or not finite,
// because v then has no direction.
inline Vec3 normalize(Vec3 v) {
    const Real squared = dot(v, v);
    if (safe_squares.contains(squared)) return v / std::sqrt(squared);
    return normalize_scaled(v);
}

}  // namespace rt
