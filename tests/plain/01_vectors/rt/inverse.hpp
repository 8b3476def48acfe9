#pragma once
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/mat4.hpp>
#include <rt/transform.hpp>
#include <stdexcept>

namespace rt {

inline Mat4 inverse(const Mat4& m) {
    const Vec3 a{m(0, 0), m(1, 0), m(2, 0)}, b{m(0, 1), m(1, 1), m(2, 1)},
        c{m(0, 2), m(1, 2), m(2, 2)};
    const Vec3 origin{m(0, 3), m(1, 3), m(2, 3)};
    const Vec3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const Real determinant = dot(a, bc);
    const Vec3 rows[] = {bc / determinant, ca / determinant, ab / determinant};
    Mat4 result;
    for (int i = 0; i < 3; ++i) {
        result(i, 0) = rows[i].x;
        result(i, 1) = rows[i].y;
        result(i, 2) = rows[i].z;
        result(i, 3) = -dot(rows[i], origin);
    }
    return result;
}

inline Vec3 to_object(const Mat4& object_to_world, Vec3 world_point) {
    return transform_point(inverse(object_to_world), world_point);
}

inline Vec3 to_world(const Mat4& object_to_world, Vec3 object_point) {
    return transform_point(object_to_world, object_point);
}

}  // namespace rt
