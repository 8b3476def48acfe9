#pragma once
#include <rt/basis.hpp>
#include <rt/cross.hpp>
#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <stdexcept>

namespace rt {

inline Basis look_at(Vec3 from, Vec3 at, Vec3 up) {
    if (up == Vec3{} || !is_finite(up)) throw std::domain_error("look_at: no up");
    const Vec3 forward = at - from;
    const Vec3 w = normalize(forward);
    const Vec3 right = cross(split_scale(up).v, split_scale(forward).v);
    if (right == Vec3{}) return orthonormal_basis(w);
    const Vec3 u = normalize(right);
    return {u, cross(w, u), w};
}

}  // namespace rt
