#pragma once
#include <rt/dot.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 05.1. The direction in which a mirror with this normal sends light that arrives along
// `incoming`: the part along the normal is reversed, and the rest stays. The length does not
// change. The normal must have length 1; either of the mirror's two normals will do.
// Star: this holds for vectors of any length, and for light that grazes the mirror.
// Source: the law of reflection.
inline Vec3 reflect(Vec3 incoming, Vec3 normal) {
    return rt::todo("05.1", incoming, normal);
}

}  // namespace rt
