#pragma once
#include <rt/camera.hpp>
#include <rt/ray.hpp>

namespace answer {

rt::Ray primary_ray(const rt::Camera& camera, int column, int row, const rt::Vec2& offset);

}  // namespace answer

namespace rt {

using answer::primary_ray;

}  // namespace rt
