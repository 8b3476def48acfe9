#pragma once
#include <algorithm>
#include <cmath>
#include <rt/real.hpp>
#include <rt/vec3_operators.hpp>
#include <rt/vec3_type.hpp>

namespace rt {

// Operators that are built from those of exercise 01.1.
[[nodiscard]] inline Vec3 operator*(Real s, Vec3 v) {
    return v * s;
}
inline Vec3& operator+=(Vec3& a, Vec3 b) {
    return a = a + b;
}
inline Vec3& operator-=(Vec3& a, Vec3 b) {
    return a = a - b;
}
inline Vec3& operator*=(Vec3& v, Real s) {
    return v = v * s;
}
inline Vec3& operator/=(Vec3& v, Real s) {
    return v = v / s;
}

// The product component by component: neither the dot nor the cross product.
[[nodiscard]] inline Vec3 operator*(Vec3 a, Vec3 b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}

// True when no component is infinite or NaN.
inline bool is_finite(Vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// The absolute values of the components.
inline Vec3 abs(Vec3 v) {
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

// The largest absolute value among the components.
inline Real max_component(Vec3 v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// A vector as v * 2^exponent, where the largest component of v lies in [1, 2) by absolute value.
struct ScaledVec3 {
    Vec3 v;
    int exponent = 0;
};

// Splits a vector so that products of its components can neither overflow nor underflow in a way
// that matters. Multiplying by a power of two rounds nothing, so the split is exact (except that
// components 2^120 times smaller than the largest may lose their last bits). The zero vector, and a
// vector that is not finite, are returned as they are, with exponent 0.
inline ScaledVec3 split_scale(Vec3 v) {
    const Real largest = max_component(v);
    if (largest == 0 || !is_finite(v)) return {v, 0};
    const int e = std::ilogb(largest);
    return {{std::scalbn(v.x, -e), std::scalbn(v.y, -e), std::scalbn(v.z, -e)}, e};
}

}  // namespace rt
