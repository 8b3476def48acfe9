#pragma once
#include <cmath>
#include <rt/basis.hpp>
#include <rt/cross.hpp>
#include <rt/length.hpp>

namespace rt {

inline Basis orthonormal_basis(Vec3 w) {
    Vec3 u = cross({0, 0, 1}, w);
    const Real squared = dot(u, u);
    u = squared > 0 ? u / std::sqrt(squared) : u;
    return {u, cross(w, u), w};
}

}  // namespace rt
