#pragma once
#include <cmath>
#include <rt/basis.hpp>

namespace rt {

// A right-handed basis with the given unit vector as its w. For every w, lengths and right angles
// are accurate to 8 epsilon (|u.u - 1|, |u.v| and so on).
// Source: Duff et al., "Building an orthonormal basis, revisited", JCGT 6(1), 2017.
inline Basis orthonormal_basis(Vec3 w) {
    const Real sign = std::copysign(Real(1), w.z);
    const Real a = -1 / (sign + w.z);  // |sign + w.z| >= 1: the division is always safe
    const Real b = w.x * w.y * a;
    return {{1 + sign * w.x * w.x * a, sign * b, -sign * w.x}, {b, sign + w.y * w.y * a, -w.y}, w};
}

}  // namespace rt
