#pragma once
#include <rt/image.hpp>
#include <rt/vec2.hpp>

namespace answer {

rt::Color bilinear(const rt::Image& image, rt::Vec2 place);

}  // namespace answer

namespace rt {

using answer::bilinear;

}  // namespace rt
