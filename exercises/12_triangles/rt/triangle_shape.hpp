#pragma once
#include <optional>
#include <rt/bounds.hpp>
#include <rt/hit_triangle.hpp>
#include <rt/mesh.hpp>
#include <rt/slab_ray.hpp>
#include <rt/todo.hpp>
#include <vector>

namespace rt {

// Exercise 12.2. The box around a triangle.
// Star: grow it on all sides by hit_margin times the largest coordinate in it, as in 07.2, so that
// no rounding lets a ray hit the triangle and miss the box. Triangles in a wall have a flat box.
inline Box bounds_of(const SceneTriangle& triangle) {
    return rt::todo("12.2", triangle);
}

// Exercise 12.2. The t at which a ray meets the triangle, or none if it misses or if that t is not
// within the interval. The tree calls this function.
inline std::optional<Real> hit_shape(const SceneTriangle& triangle, const Ray& ray,
                                     Interval within) {
    return rt::todo("12.2", triangle, ray, within);
}

// Exercise 12.2. The triangles of a mesh in their order, all with this material, and numbered from
// `first` on.
inline std::vector<SceneTriangle> triangles_of(const Mesh& mesh, int material, int first) {
    return rt::todo("12.2", mesh, material, first);
}

}  // namespace rt
