#pragma once
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/mat4.hpp>
#include <rt/transform.hpp>
#include <stdexcept>

namespace rt {

inline Mat4 inverse(const Mat4& m) {
    const Vec3 a{m(0, 0), m(1, 0), m(2, 0)};
    const Vec3 b{m(0, 1), m(1, 1), m(2, 1)};
    const Vec3 c{m(0, 2), m(1, 2), m(2, 2)};
    const Vec3 t{m(0, 3), m(1, 3), m(2, 3)}, bc = cross(b, c);
    const Real d = dot(a, bc);
    const Real size = std::abs(a.x * bc.x) + std::abs(a.y * bc.y) + std::abs(a.z * bc.z);
    if (!(std::abs(d) > rounding_bound(6) * size)) throw std::domain_error("singular");
    const Vec3 x = bc;
    const Vec3 y = cross(c, a);
    const Vec3 z = cross(a, b);
    return {{{{x.x, x.y, x.z, -dot(x, t)},
              {y.x, y.y, y.z, -dot(y, t)},
              {z.x, z.y, z.z, -dot(z, t)},
              {0, 0, 0, 1}}}};
}

inline Vec3 to_object(const Mat4& object_to_world, Vec3 world_point) {
    return transform_point(inverse(object_to_world), world_point);
}

inline Vec3 to_world(const Mat4& object_to_world, Vec3 object_point) {
    return transform_point(object_to_world, object_point);
}

}  // namespace rt
