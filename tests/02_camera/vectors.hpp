#pragma once
// Errors of vectors of length 1, in units in the last place of 1.

#include "checkpoint.hpp"

namespace checkpoint {

inline double dot_in_double(Vec3 a, Vec3 b) {  // where the products of floats are exact
    return static_cast<double>(a.x) * static_cast<double>(b.x) +
           static_cast<double>(a.y) * static_cast<double>(b.y) +
           static_cast<double>(a.z) * static_cast<double>(b.z);
}

inline double error_in_ulp_of_1(Vec3 computed, const ExactVec3& exact) {
    if (!is_finite(computed)) return std::numeric_limits<double>::infinity();
    const auto error = [](Real c, Exact e) { return std::abs((e - Exact(c)).high); };
    return std::max({error(computed.x, exact.x), error(computed.y, exact.y),
                     error(computed.z, exact.z)}) /
           static_cast<double>(rt::epsilon);
}

// How far the length is from 1; infinite for a vector that is not finite.
inline double length_error_in_ulp(Vec3 v) {
    if (!is_finite(v)) return std::numeric_limits<double>::infinity();
    return std::abs(std::sqrt(dot_in_double(v, v)) - 1) / static_cast<double>(rt::epsilon);
}

}  // namespace checkpoint
