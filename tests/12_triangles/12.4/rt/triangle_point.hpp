#pragma once
#include <rt/hit.hpp>
#include <rt/triangle.hpp>

namespace answer {

rt::Hit surface_hit(const rt::SceneTriangle& triangle, const rt::Ray& ray, rt::Real t);

}  // namespace answer

namespace rt {

using answer::surface_hit;

}  // namespace rt
