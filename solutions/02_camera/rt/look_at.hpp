#pragma once
#include <rt/basis.hpp>
#include <rt/cross.hpp>
#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <stdexcept>

namespace rt {

// The basis of a camera at `from` that looks at `at`, along -w; in the picture u points right and v
// up. v lies in the plane of w and `up`. If the view is parallel to `up`, there is no such plane,
// and any u and v that complete the basis will do. Throws std::domain_error if `from` equals `at`,
// `up` is zero, or a number is not finite.
inline Basis look_at(Vec3 from, Vec3 at, Vec3 up) {
    Vec3 back = from - at;
    // If the vector is too long for Real, half of it fits, and only its direction counts.
    if (!is_finite(back)) back = from / 2 - at / 2;
    if (back == Vec3{} || !is_finite(back))
        throw std::domain_error("look_at: the camera must look at a point other than its own");
    if (up == Vec3{} || !is_finite(up))
        throw std::domain_error("look_at: up must be a direction, not zero");
    const Vec3 w = normalize(back);
    // normalize(up) and w are not used here: rounding to length 1 turns each vector a little, and
    // if the two are nearly parallel, the angle between them is no larger than that. Scaling by
    // powers of two rounds nothing.
    const Vec3 right = cross(split_scale(up).v, split_scale(back).v);
    if (right == Vec3{}) return orthonormal_basis(w);
    const Vec3 u = normalize(right);
    return {u, cross(w, u), w};
}

}  // namespace rt
