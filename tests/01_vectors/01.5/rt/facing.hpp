#pragma once
#include <rt/vec3.hpp>

namespace answer {

int facing(const rt::Vec3& normal, const rt::Vec3& to_viewer);

}  // namespace answer

namespace rt {

using answer::facing;

}  // namespace rt
