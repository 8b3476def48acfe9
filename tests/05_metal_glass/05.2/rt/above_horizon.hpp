#pragma once
#include <rt/vec3.hpp>

namespace answer {

rt::Vec3 above_horizon(rt::Vec3 v, rt::Vec3 normal);

}  // namespace answer

namespace rt {

using answer::above_horizon;

}  // namespace rt
