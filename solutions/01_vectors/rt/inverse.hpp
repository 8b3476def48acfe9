#pragma once
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/mat4.hpp>
#include <rt/transform.hpp>
#include <stdexcept>

namespace rt {

// The map that undoes m. Throws std::domain_error if m flattens space (is singular), if m is so
// nearly singular that rounding decides the result, or if a number in m is not finite. A number of
// the inverse that is too large for Real becomes infinite. Each number of the linear part is
// accurate to 4 + 6 k units in the last place, where k measures how much the determinant cancels.
// Expand the determinant along a row or a column, and divide the sum of its terms' absolute values
// by the determinant's absolute value: k is the largest such quotient, and 1 where nothing cancels.
// All rows share one k, because one determinant divides them all. Each number of a column must be
// 0, or less than 10^140 times (float: 10^15 times) smaller than the column's largest.
inline Mat4 inverse(const Mat4& m) {
    // Columns of the linear part, each scaled so that no product of three numbers can overflow.
    const auto [a, a_exponent] = split_scale({m(0, 0), m(1, 0), m(2, 0)});
    const auto [b, b_exponent] = split_scale({m(0, 1), m(1, 1), m(2, 1)});
    const auto [c, c_exponent] = split_scale({m(0, 2), m(1, 2), m(2, 2)});
    const Vec3 origin{m(0, 3), m(1, 3), m(2, 3)};

    // b x c is perpendicular to b and c, so its dot product with either is 0; with a it is the
    // determinant. Divided by the determinant, b x c is the first row of the inverse. The other
    // rows are found likewise.
    const Vec3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const Real determinant = dot(a, bc);

    // Each component of `bc` has 3 rounding errors, and the dot product adds 3 more. A determinant
    // that is no farther from zero than these errors may well be zero. NaN fails the test, too.
    const Real size = std::abs(a.x * bc.x) + std::abs(a.y * bc.y) + std::abs(a.z * bc.z);
    if (!(std::abs(determinant) > rounding_bound(6) * size) || !is_finite(origin))
        throw std::domain_error("inverse: the matrix is singular, it cannot be undone");

    const auto row = [&](Vec3 scaled, int exponent) -> std::array<Real, 4> {
        scaled /= determinant;
        const Vec3 r{std::scalbn(scaled.x, -exponent), std::scalbn(scaled.y, -exponent),
                     std::scalbn(scaled.z, -exponent)};
        Real move = -dot(r, origin);
        // Undoing the scale first could give infinity times 0, or infinity minus infinity.
        if (!std::isfinite(move)) {
            const auto [o, o_exponent] = split_scale(origin);
            move = std::scalbn(-dot(scaled, o), o_exponent - exponent);
        }
        return {r.x, r.y, r.z, move};
    };
    return {{{row(bc, a_exponent), row(ca, b_exponent), row(ab, c_exponent), {0, 0, 0, 1}}}};
}

// A point of the world in the object's own coordinates, given the map that places the object in the
// world. Throws std::domain_error if that map is singular. If its inverse contains an infinite
// number, the coordinate that is computed from this number is infinite or NaN.
inline Vec3 to_object(const Mat4& object_to_world, Vec3 world_point) {
    return transform_point(inverse(object_to_world), world_point);
}

// The way back: a point of the object in the world's coordinates.
inline Vec3 to_world(const Mat4& object_to_world, Vec3 object_point) {
    return transform_point(object_to_world, object_point);
}

}  // namespace rt
