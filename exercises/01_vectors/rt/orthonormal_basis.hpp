#pragma once
#include <cmath>
#include <rt/basis.hpp>
#include <rt/cross.hpp>
#include <rt/length.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 01.8. A right-handed basis (u x v = w) whose w is the given unit vector, which may have
// any direction.
// Star: lengths and right angles are accurate to 8 epsilon (|u.u - 1|, |u.v| and so on).
inline Basis orthonormal_basis(Vec3 w) {
    return rt::todo("01.8", w);
}

}  // namespace rt
