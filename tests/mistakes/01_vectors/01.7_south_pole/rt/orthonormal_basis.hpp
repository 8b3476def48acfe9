#pragma once
#include <cmath>
#include <rt/basis.hpp>
#include <rt/cross.hpp>
#include <rt/length.hpp>

namespace rt {

inline Basis orthonormal_basis(Vec3 w) {
    const Real a = -1 / (1 + w.z), b = w.x * w.y * a;
    return {{1 + w.x * w.x * a, b, -w.x}, {b, 1 + w.y * w.y * a, -w.y}, w};
}

}  // namespace rt
