#pragma once
#include <optional>
#include <rt/box.hpp>
#include <rt/interval.hpp>
#include <rt/mesh.hpp>
#include <rt/triangle.hpp>
#include <vector>

namespace answer {

rt::Box bounds_of(const rt::SceneTriangle& triangle);
std::optional<rt::Real> hit_shape(const rt::SceneTriangle& triangle, const rt::Ray& ray,
                                  rt::Interval within);
std::vector<rt::SceneTriangle> triangles_of(const rt::Mesh& mesh, int material, int first);

}  // namespace answer

namespace rt {

using answer::bounds_of;
using answer::hit_shape;
using answer::triangles_of;

}  // namespace rt
