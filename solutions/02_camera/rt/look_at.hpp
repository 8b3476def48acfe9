#pragma once
#include <rt/basis.hpp>
#include <rt/cross.hpp>
#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>

namespace rt {

// The basis of a camera at `from` that looks at `at`, along -w; u points right, v up in the
// picture. v lies in the plane of w and up. Where the view is parallel to up, no such plane exists,
// and u and v are any that fit. Throws std::domain_error when from equals at or up is zero.
inline Basis look_at(Vec3 from, Vec3 at, Vec3 up) {
    const Vec3 w = normalize(from - at);
    const Vec3 right = cross(normalize(up), w);
    // w and the unit vector along up have rounding errors of up to 3 units in the last place each.
    // A cross product no longer than those points nowhere in particular.
    if (length(right) <= rounding_bound(12)) return orthonormal_basis(w);
    const Vec3 u = normalize(right);
    return {u, cross(w, u), w};
}

}  // namespace rt
