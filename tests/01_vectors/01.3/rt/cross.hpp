#pragma once
#include <rt/vec3.hpp>

namespace answer {

rt::Vec3 cross(const rt::Vec3& a, const rt::Vec3& b);

}  // namespace answer

namespace rt {

using answer::cross;

}  // namespace rt
