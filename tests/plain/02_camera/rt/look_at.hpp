#pragma once
#include <rt/basis.hpp>
#include <rt/cross.hpp>
#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <stdexcept>

namespace rt {

inline Basis look_at(Vec3 from, Vec3 at, Vec3 up) {
    const Vec3 w = normalize(from - at);
    const Vec3 right = cross(up, w);
    if (right == Vec3{}) return orthonormal_basis(w);
    const Vec3 u = normalize(right);
    return {u, cross(w, u), w};
}

}  // namespace rt
