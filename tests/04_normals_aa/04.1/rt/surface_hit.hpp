#pragma once
#include <rt/hit.hpp>
#include <rt/ray.hpp>
#include <rt/sphere.hpp>

namespace answer {

rt::Hit surface_hit(const rt::Sphere& sphere, const rt::Ray& ray, rt::Real t);

}  // namespace answer

namespace rt {

using answer::surface_hit;

}  // namespace rt
