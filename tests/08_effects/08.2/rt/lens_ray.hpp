#pragma once
#include <rt/length.hpp>
#include <rt/lens.hpp>
#include <rt/pixel.hpp>
#include <rt/ray.hpp>

namespace answer {

rt::Ray lens_ray(const rt::Camera& camera, const rt::Lens& lens, int column, int row,
                 rt::Vec2 offset, rt::Vec2 place);

}  // namespace answer

namespace rt {

using answer::lens_ray;

}  // namespace rt
