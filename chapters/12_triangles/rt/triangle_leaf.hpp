#pragma once
#include <bit>
#include <limits>
#include <rt/sheared_ray.hpp>
#include <rt/triangle_point.hpp>
#include <rt/triangle_shape.hpp>
#include <rt/wide_tree.hpp>

namespace rt {

// A ray that is ready for the tests of leaves.
struct TriangleRay : Ray {
    ShearedRay sheared;
    explicit TriangleRay(const Ray& ray) : Ray{ray}, sheared{ray} {}
};

// A leaf with up to eight triangles (given). A quick test of all triangles at once finds the few
// that hit_triangle (12.1) must test.
template <>
struct alignas(64) WideLeaf<SceneTriangle> {
    using ReadyRay = TriangleRay;
    // All that may_meet and place_of read.
    static constexpr std::size_t read_ahead = 9 * sizeof(Lanes<Real>) + sizeof(Lanes<std::int32_t>);
    // Coordinates by corner, then by axis. Unused lanes hold NaN, so that no ray hits them.
    std::array<std::array<Lanes<Real>, 3>, 3> corner;
    Lanes<std::int32_t> number{}, material{};

    WideLeaf() {
        for (auto& axes : corner)
            for (auto& numbers : axes) numbers.fill(std::numeric_limits<Real>::quiet_NaN());
    }

    void set(std::size_t place, const SceneTriangle& triangle, std::int32_t its_number) {
        const std::array<Vec3, 3> points{triangle.shape.a, triangle.shape.b, triangle.shape.c};
        for (std::size_t k = 0; k < 3; ++k)
            for (int axis = 0; axis < 3; ++axis)
                corner[k][static_cast<std::size_t>(axis)][place] = along(points[k], axis);
        number[place] = its_number;
        material[place] = triangle.material;
    }
    // The place of the triangle with this number, which must be here.
    std::size_t place_of(std::int32_t its_number) const {
        unsigned places = 0;
        for (std::size_t i = 0; i < lanes; ++i)
            places |= static_cast<unsigned>(number[i] == its_number) << i;
        return static_cast<std::size_t>(std::countr_zero(places));
    }
    // A triangle's number in the tree is its number in the scene.
    SceneTriangle shape(std::size_t i) const {
        const auto point = [&](std::size_t k) {
            return Vec3{corner[k][0][i], corner[k][1][i], corner[k][2][i]};
        };
        return {{point(0), point(1), point(2)}, material[i], number[i]};
    }
};
using TriangleLeaf = WideLeaf<SceneTriangle>;

// Some of a leaf's triangles, as seen along a ray (given), with the formulas of ShearedRay::seen
// and area_before.
struct TrianglePart {
    std::array<Reals, 3> x, y, z;  // of the corners

    RT_INLINED TrianglePart(const TriangleLeaf& leaf, std::size_t first, const ShearedRay& ray) {
        const std::array<Real, 3> origin{ray.origin.x, ray.origin.y, ray.origin.z};
        const auto axis = [&](std::size_t k, int along_axis) {
            const auto i = static_cast<std::size_t>(along_axis);
            return load<Reals>(&leaf.corner[k][i][first]) - origin[i];
        };
        for (std::size_t k = 0; k < 3; ++k) {
            const Reals ahead = axis(k, ray.z);
            x[k] = axis(k, ray.x) - ray.shear_x * ahead;
            y[k] = axis(k, ray.y) - ray.shear_y * ahead;
            z[k] = ray.per_length * ahead;
        }
    }

    // Those that hit_triangle may find within the interval, as bits. Two kinds are left out:
    //
    // Triangles beside the ray: two of the three areas have opposite signs. Rounding may turn a
    // difference of products into 0, but never gives it the wrong sign.
    //
    // Triangles before or behind the interval. The hit's t is sum_t / sum, and compared without
    // the division. The products of an area are rounded, so with u = epsilon / 2, the area is off
    // by at most 2 u size. With the roundings that follow, sum_t - end * sum is off by at most
    // u (6 error_t + 7 |end| error), and the t of hit_triangle, times sum, by at most
    // 12 u error_t. In all, that is less than 9 epsilon (error_t + |end| error). `tiny` stands for
    // what numbers too small for all their digits lose.
    RT_INLINED unsigned may_be_hit(Interval within) const {
        constexpr Real tiny = std::numeric_limits<Real>::min();
        std::array<Reals, 3> area;
        Reals sum{}, sum_t{}, error{}, error_t{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t p = (k + 1) % 3, q = (k + 2) % 3;
            const Reals left = x[p] * y[q], right = y[p] * x[q];
            const Reals size = abs(left) + abs(right) + tiny;
            area[k] = left - right;
            sum += area[k];
            sum_t += area[k] * z[k];
            error += size;
            error_t += size * abs(z[k]);
        }
        const auto& [a, b, c] = area;
        const auto around = ((a >= 0) & (b >= 0) & (c >= 0)) | ((a <= 0) & (b <= 0) & (c <= 0));

        sum_t = sum < 0 ? -sum_t : sum_t;
        sum = abs(sum);
        const auto most = [&](Real end) -> Reals {
            return 10 * epsilon * (error_t + std::abs(end) * error) + tiny;
        };
        const auto outside = (sum_t - within.min * sum < -most(within.min)) |
                             (sum_t - within.max * sum > most(within.max));
        return RT_VECTOR_BITS(around & ~outside);
    }
};

// The triangles of a leaf that the ray may meet within the interval, as bits.
RT_INLINED unsigned may_meet(const TriangleLeaf& leaf, const TriangleRay& ray, Interval within) {
    unsigned met = 0;
    for (std::size_t first = 0; first < lanes; first += part_size<Real>)
        met |= TrianglePart{leaf, first, ray.sheared}.may_be_hit(within) << first;
    return met;
}

using TriangleTree = WideTreeOf<SceneTriangle>;

}  // namespace rt
