#pragma once
#include <rt/vec3.hpp>

namespace answer {

rt::Real lambert(rt::Vec3 normal, rt::Vec3 to_light);

}  // namespace answer

namespace rt {

using answer::lambert;

}  // namespace rt
