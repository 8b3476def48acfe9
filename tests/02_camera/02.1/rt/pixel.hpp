#pragma once
#include <rt/camera.hpp>

namespace answer {

rt::Vec2 pixel_to_viewport(const rt::Camera& camera, int column, int row, const rt::Vec2& offset);

}  // namespace answer

namespace rt {

using answer::pixel_to_viewport;

}  // namespace rt
