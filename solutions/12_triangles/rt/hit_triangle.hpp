#pragma once
#include <optional>
#include <rt/cross.hpp>
#include <rt/interval.hpp>
#include <rt/sheared_ray.hpp>
#include <rt/triangle.hpp>

namespace rt {

// Twice the area of the triangle (0, 0), p, q: greater than 0 if the edge from p to q goes around
// (0, 0) counterclockwise, and less than 0 if it goes clockwise. The sign is exact.
inline Real area_before(Vec3 p, Vec3 q) {
    return difference_of_products(p.x, q.y, p.y, q.x);
}

// True if the edge from p to q goes around the ray counterclockwise. If the ray meets the edge
// itself, the ray counts as moved a little along x, and far less along y, so that it hits exactly
// one of two triangles on different sides of this edge.
inline bool goes_around(Vec3 p, Vec3 q, Real area) {
    if (area != 0) return area > 0;
    return p.y != q.y ? p.y > q.y : p.x < q.x;
}

// The hit of a ray and a triangle at a t within the interval, from either side. Returns none for a
// triangle without area. The point of the ray at t is off the triangle's plane by at most 16
// epsilon times the largest coordinate of a corner as seen from the ray's origin. A ray through an
// edge that two triangles share hits exactly one of them if they lie on different sides of the edge
// as the ray sees it, and both or none if they lie on the same side (at an outline), as long as the
// areas neither overflow nor underflow.
inline std::optional<TriangleHit> hit_triangle(const Triangle& triangle, const Ray& ray,
                                               Interval within) {
    const ShearedRay sheared{ray};
    const Vec3 a = sheared.seen(triangle.a), b = sheared.seen(triangle.b),
               c = sheared.seen(triangle.c);
    const Real of_a = area_before(b, c), of_b = area_before(c, a), of_c = area_before(a, b);
    const bool around = goes_around(b, c, of_a);
    if (goes_around(c, a, of_b) != around || goes_around(a, b, of_c) != around) return {};

    // All three areas have the same sign, so the sum loses no digits.
    const Real sum = of_a + of_b + of_c;
    const Real t = (of_a * a.z + of_b * b.z + of_c * c.z) / sum;
    if (!within.contains(t)) return {};
    if (cross(triangle.b - triangle.a, triangle.c - triangle.a) == Vec3{}) return {};
    return TriangleHit{t, of_b / sum, of_c / sum};
}

}  // namespace rt
