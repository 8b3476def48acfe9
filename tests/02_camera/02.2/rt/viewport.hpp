#pragma once
#include <rt/camera.hpp>

namespace answer {

rt::Viewport viewport_size(rt::Real vertical_fov, rt::Real aspect_ratio);

}  // namespace answer

namespace rt {

using answer::viewport_size;

}  // namespace rt
