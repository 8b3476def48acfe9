#pragma once
#include <cmath>
#include <rt/basis.hpp>
#include <rt/cross.hpp>
#include <rt/length.hpp>

namespace rt {

inline Basis orthonormal_basis(Vec3 w) {
    const Real x = std::abs(w.x), y = std::abs(w.y), z = std::abs(w.z);
    Vec3 axis{1, 0, 0};
    if (y <= x && y <= z) axis = {0, 1, 0};
    if (z <= x && z <= y) axis = {0, 0, 1};
    const Vec3 u = normalize(cross(axis, w));
    return {u, cross(w, u), w};
}

}  // namespace rt
