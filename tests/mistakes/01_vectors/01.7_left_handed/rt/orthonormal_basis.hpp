#pragma once
#include <cmath>
#include <rt/basis.hpp>
#include <rt/cross.hpp>
#include <rt/length.hpp>

namespace rt {

inline Basis orthonormal_basis(Vec3 w) {
    const Vec3 helper = std::abs(w.x) < Real(0.6) ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 u = normalize(cross(helper, w));
    return {cross(w, u), u, w};
}

}  // namespace rt
