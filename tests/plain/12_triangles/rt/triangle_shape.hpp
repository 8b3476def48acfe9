#pragma once
#include <optional>
#include <rt/bounds.hpp>
#include <rt/hit_triangle.hpp>
#include <rt/mesh.hpp>
#include <vector>

namespace rt {

inline Box bounds_of(const SceneTriangle& triangle) {
    const auto& [a, b, c] = triangle.shape;
    return join(join({a, a}, {b, b}), {c, c});
}

inline std::optional<Real> hit_shape(const SceneTriangle& triangle, const Ray& ray,
                                     Interval within) {
    const auto hit = hit_triangle(triangle.shape, ray, within);
    if (!hit) return {};
    return hit->t;
}

inline std::vector<SceneTriangle> triangles_of(const Mesh& mesh, int material, int first) {
    std::vector<SceneTriangle> triangles;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 at_a = mesh.points[static_cast<std::size_t>(a.point)];
        const Vec3 at_b = mesh.points[static_cast<std::size_t>(b.point)];
        const Vec3 at_c = mesh.points[static_cast<std::size_t>(c.point)];
        triangles.push_back({{at_a, at_b, at_c}, material, first});
        ++first;
    }
    return triangles;
}

}  // namespace rt
