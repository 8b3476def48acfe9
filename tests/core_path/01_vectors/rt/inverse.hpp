#pragma once
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/mat4.hpp>
#include <rt/transform.hpp>

namespace rt {
inline Mat4 inverse(const Mat4& m) {
    const Vec3 a{m(0, 0), m(1, 0), m(2, 0)}, b{m(0, 1), m(1, 1), m(2, 1)},
        c{m(0, 2), m(1, 2), m(2, 2)};
    const Vec3 t{m(0, 3), m(1, 3), m(2, 3)};
    const Real d = dot(a, cross(b, c));
    const Vec3 row0 = cross(b, c) / d, row1 = cross(c, a) / d, row2 = cross(a, b) / d;
    Mat4 result;
    result(0, 0) = row0.x;
    result(0, 1) = row0.y;
    result(0, 2) = row0.z;
    result(0, 3) = -dot(row0, t);
    result(1, 0) = row1.x;
    result(1, 1) = row1.y;
    result(1, 2) = row1.z;
    result(1, 3) = -dot(row1, t);
    result(2, 0) = row2.x;
    result(2, 1) = row2.y;
    result(2, 2) = row2.z;
    result(2, 3) = -dot(row2, t);
    return result;
}
inline Vec3 to_object(const Mat4& object_to_world, Vec3 p) {
    return transform_point(inverse(object_to_world), p);
}
inline Vec3 to_world(const Mat4& object_to_world, Vec3 p) {
    return transform_point(object_to_world, p);
}
}  // namespace rt
