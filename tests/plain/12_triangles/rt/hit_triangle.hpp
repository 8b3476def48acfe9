#pragma once
#include <optional>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/interval.hpp>
#include <rt/triangle.hpp>

namespace rt {

inline std::optional<TriangleHit> hit_triangle(const Triangle& triangle, const Ray& ray,
                                               Interval within) {
    const Vec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
    const Vec3 across = cross(ray.direction, ac);
    const Real det = dot(ab, across);
    if (det == 0) return {};
    const Vec3 from_a = ray.origin - triangle.a;
    const Vec3 turned = cross(from_a, ab);
    const Real u = dot(from_a, across) / det, v = dot(ray.direction, turned) / det;
    if (u < 0 || v < 0 || u + v > 1) return {};
    const Real t = dot(ac, turned) / det;
    if (!within.contains(t)) return {};
    return TriangleHit{t, u, v};
}

}  // namespace rt
