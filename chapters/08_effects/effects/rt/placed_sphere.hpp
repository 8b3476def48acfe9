#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <rt/dot.hpp>
#include <rt/inverse.hpp>
#include <rt/length.hpp>
#include <rt/slab_ray.hpp>
#include <rt/sphere.hpp>
#include <rt/transform.hpp>
#include <type_traits>

namespace rt {

// The sphere of radius 1 around the origin, placed in the world by a matrix (given): an ellipsoid
// with any position and orientation. Such a copy of a shape is called an instance.
struct Instance {
    Mat4 object_to_world, world_to_object;  // each is the other's inverse
    // An integer as long as a Real, so that no padding follows: with -ftrivial-auto-var-init, which
    // answers are compiled with, g++ 12 loses a number of the first matrix when such an object is
    // returned.
    std::conditional_t<sizeof(Real) == 8, std::int64_t, std::int32_t> material = 0;
};

// Throws std::domain_error if the matrix is singular.
inline Instance make_instance(const Mat4& object_to_world, int material) {
    return {object_to_world, inverse(object_to_world), material};
}

inline constexpr Sphere unit_sphere{{0, 0, 0}, 1};

// What rounding does to the two maps (given).

// The map whose coefficients are the absolute values of this map's.
inline Mat4 abs(Mat4 map) {
    for (auto& row : map.rows)
        for (Real& number : row) number = std::abs(number);
    return map;
}

// How far the point may lie off the instance's surface, along the normal. For leave_surface: a ray
// that starts this far away from the surface does not meet it again at once.
inline Real instance_error(const Instance& instance, Vec3 point) {
    const Mat4& m = instance.world_to_object;
    // How far off the point is in the object's space, where the surface is at distance 1 from the
    // origin.
    const Vec3 there = transform_point(m, point);
    const Real off = std::abs(length(there) - 1);
    // Each coordinate there is rounded 4 times now, and 4 times more when a ray starts from here.
    const Real rounding = rounding_bound(8) * dot(abs(there), transform_point(abs(m), abs(point)));
    // 16 as in surface_hit, and 3 for the length. The quotient turns a distance in the object's
    // space into a step along the normal in the world.
    return (off + rounding + rounding_bound(19)) / length(transform_normal(m, there));
}

// The factor by which hit_margin must be multiplied for an instance's box. The longer the
// ellipsoid, the larger the ray's rounding errors in the object's space are, relative to the unit
// sphere. The row sums of |M| |inverse of M|, where M is the matrix, tell how large these errors
// are in the world. The factor is 1 for a sphere, and at most 3 for a turned sphere.
inline Real margin_factor(const Instance& instance) {
    Real largest = 1;
    for (int row = 0; row < 3; ++row) {
        Real sum = 0;
        for (int k = 0; k < 3; ++k)
            for (int column = 0; column < 3; ++column)
                sum += std::abs(instance.object_to_world(row, k) *
                                instance.world_to_object(k, column));
        largest = std::max(largest, sum);
    }
    return largest;
}

}  // namespace rt
