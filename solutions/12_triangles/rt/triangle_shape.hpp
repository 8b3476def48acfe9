#pragma once
#include <algorithm>
#include <optional>
#include <rt/bounds.hpp>
#include <rt/hit_triangle.hpp>
#include <rt/mesh.hpp>
#include <rt/slab_ray.hpp>
#include <vector>

namespace rt {

// The box around a triangle, grown by hit_margin times the largest coordinate in it, so that no
// rounding of the tests lets a ray hit the triangle and miss the box.
inline Box bounds_of(const SceneTriangle& triangle) {
    const auto& [a, b, c] = triangle.shape;
    const Box box = join(join({a, a}, {b, b}), {c, c});
    const Real margin = hit_margin * std::max(max_component(box.low), max_component(box.high));
    const Vec3 grown{margin, margin, margin};
    return {box.low - grown, box.high + grown};
}

// The t within the interval at which a ray meets the triangle, or none. The tree calls this
// function.
inline std::optional<Real> hit_shape(const SceneTriangle& triangle, const Ray& ray,
                                     Interval within) {
    const auto hit = hit_triangle(triangle.shape, ray, within);
    if (!hit) return {};
    return hit->t;
}

// The triangles of a mesh in their order, all with this material, and numbered from `first` on.
inline std::vector<SceneTriangle> triangles_of(const Mesh& mesh, int material, int first) {
    std::vector<SceneTriangle> triangles;
    triangles.reserve(mesh.triangles.size());
    const auto point = [&](const Corner& corner) {
        return mesh.points[static_cast<std::size_t>(corner.point)];
    };
    for (const auto& [a, b, c] : mesh.triangles)
        triangles.push_back({{point(a), point(b), point(c)}, material, first++});
    return triangles;
}

}  // namespace rt
