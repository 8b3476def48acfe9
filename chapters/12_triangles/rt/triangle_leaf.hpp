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
    static constexpr bool is_read_ahead = true;
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
// and area_before. Rounding may turn a difference of products into 0, but never gives the
// difference the wrong sign. So if two areas of a triangle have opposite signs, the ray misses the
// triangle.
struct TrianglePart {
    std::array<Reals, 3> x, y;

    RT_INLINED TrianglePart(const TriangleLeaf& leaf, std::size_t first, const ShearedRay& ray) {
        const auto axis = [&](std::size_t k, int along_axis) {
            return load<Reals>(&leaf.corner[k][static_cast<std::size_t>(along_axis)][first]) -
                   along(ray.origin, along_axis);
        };
        for (std::size_t k = 0; k < 3; ++k) {
            const Reals ahead = axis(k, ray.z);
            x[k] = axis(k, ray.x) - ray.shear_x * ahead;
            y[k] = axis(k, ray.y) - ray.shear_y * ahead;
        }
    }
    RT_INLINED Reals area(std::size_t p, std::size_t q) const { return x[p] * y[q] - y[p] * x[q]; }

    RT_INLINED unsigned line_may_meet() const {
        const Reals a = area(1, 2), b = area(2, 0), c = area(0, 1);
        return RT_VECTOR_BITS(((a >= 0) & (b >= 0) & (c >= 0)) | ((a <= 0) & (b <= 0) & (c <= 0)));
    }
};

// The triangles of a leaf that the ray's line may meet, as bits.
RT_INLINED unsigned may_meet(const TriangleLeaf& leaf, const TriangleRay& ray, Interval) {
    unsigned met = 0;
    for (std::size_t first = 0; first < lanes; first += part_size<Real>)
        met |= TrianglePart{leaf, first, ray.sheared}.line_may_meet() << first;
    return met;
}

using TriangleTree = WideTreeOf<SceneTriangle>;

}  // namespace rt
