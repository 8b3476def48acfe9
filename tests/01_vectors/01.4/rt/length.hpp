#pragma once
#include <rt/vec3.hpp>
#include <stdexcept>

namespace answer {

rt::Real length(const rt::Vec3& v);
rt::Vec3 normalize(const rt::Vec3& v);

}  // namespace answer

namespace rt {

using answer::length;
using answer::normalize;

}  // namespace rt
