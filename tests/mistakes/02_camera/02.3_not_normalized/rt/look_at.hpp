#pragma once
#include <rt/basis.hpp>
#include <rt/cross.hpp>
#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <stdexcept>

namespace rt {

inline Basis look_at(Vec3 from, Vec3 at, Vec3 up) {
    const Vec3 back = from - at;
    if (back == Vec3{} || up == Vec3{} || !is_finite(back) || !is_finite(up))
        throw std::domain_error("look_at: no direction");
    const Vec3 w = normalize(back);
    const Vec3 right = cross(split_scale(up).v, split_scale(back).v);
    if (right == Vec3{}) return orthonormal_basis(w);
    const Vec3 u = cross(normalize(up), w);
    return {u, cross(w, u), w};
}

}  // namespace rt
