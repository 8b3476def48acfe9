#pragma once
#include <rt/vec3.hpp>

namespace answer {

rt::Real dot(const rt::Vec3& a, const rt::Vec3& b);

}  // namespace answer

namespace rt {

using answer::dot;

}  // namespace rt
