#pragma once
#include <rt/basis.hpp>
#include <rt/cross.hpp>
#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/todo.hpp>
#include <stdexcept>

namespace rt {

// Exercise 02.3. The basis of a camera at `from` that looks at `at`, along -w; in the picture u
// points right and v up. v lies in the plane of w and `up`, which may have any length and any
// direction. If the view is parallel to `up`, there is no such plane, and any u and v that complete
// the basis will do.
// Star: if the view is nearly parallel to `up`, each component of u is still within 8 units in the
// last place. Coordinates may be tiny, or so huge that from - at overflows. Throws
// std::domain_error if `from` equals `at`, `up` is zero, or a number is not finite.
inline Basis look_at(Vec3 from, Vec3 at, Vec3 up) {
    return rt::todo("02.3", from, at, up);
}

}  // namespace rt
