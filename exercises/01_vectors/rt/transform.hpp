#pragma once
#include <rt/mat4.hpp>
#include <rt/todo.hpp>
#include <rt/vec3.hpp>

namespace rt {

// Exercise 01.6. m(row, column) is the number in that row and column, both counted from 0.
// Star: the rounding error of each number that you compute is at most rounding_bound(5) times the
// sum of the absolute values of its terms.

// The point to which the map takes p: the linear part and the translation apply.
inline Vec3 transform_point(const Mat4& m, Vec3 p) {
    return rt::todo("01.6", m, p);
}

// The direction to which the map takes v. A direction has no position, so the linear part alone
// applies.
inline Vec3 transform_vector(const Mat4& m, Vec3 v) {
    return rt::todo("01.6", m, v);
}

// The direction to which a map takes a surface's normal n, given the INVERSE of that map: the
// inverse's linear part, transposed, times n. The result is perpendicular to the transformed
// surface; its length may differ from that of n.
inline Vec3 transform_normal(const Mat4& inverse, Vec3 n) {
    return rt::todo("01.6", inverse, n);
}

// The map that applies b first, then a.
inline Mat4 multiply(const Mat4& a, const Mat4& b) {
    return rt::todo("01.6", a, b);
}

}  // namespace rt
