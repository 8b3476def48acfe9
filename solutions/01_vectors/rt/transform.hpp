#pragma once
#include <rt/mat4.hpp>
#include <rt/vec3.hpp>

namespace rt {

// The point to which the map takes p: the linear part and the translation apply.
inline Vec3 transform_point(const Mat4& m, Vec3 p) {
    return {m(0, 0) * p.x + m(0, 1) * p.y + m(0, 2) * p.z + m(0, 3),
            m(1, 0) * p.x + m(1, 1) * p.y + m(1, 2) * p.z + m(1, 3),
            m(2, 0) * p.x + m(2, 1) * p.y + m(2, 2) * p.z + m(2, 3)};
}

// The direction to which the map takes v. A direction has no position, so the linear part alone
// applies.
inline Vec3 transform_vector(const Mat4& m, Vec3 v) {
    return {m(0, 0) * v.x + m(0, 1) * v.y + m(0, 2) * v.z,
            m(1, 0) * v.x + m(1, 1) * v.y + m(1, 2) * v.z,
            m(2, 0) * v.x + m(2, 1) * v.y + m(2, 2) * v.z};
}

// The direction to which a map takes a surface's normal n, given the INVERSE of that map: the
// inverse's linear part, transposed, times n. The result is perpendicular to the transformed
// surface; its length may differ from that of n.
inline Vec3 transform_normal(const Mat4& inverse, Vec3 n) {
    return {inverse(0, 0) * n.x + inverse(1, 0) * n.y + inverse(2, 0) * n.z,
            inverse(0, 1) * n.x + inverse(1, 1) * n.y + inverse(2, 1) * n.z,
            inverse(0, 2) * n.x + inverse(1, 2) * n.y + inverse(2, 2) * n.z};
}

// The map that applies b first, then a.
inline Mat4 multiply(const Mat4& a, const Mat4& b) {
    Mat4 product;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            product(row, column) = 0;
            for (int k = 0; k < 4; ++k) product(row, column) += a(row, k) * b(k, column);
        }
    return product;
}

}  // namespace rt
