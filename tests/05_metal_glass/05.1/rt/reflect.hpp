#pragma once
#include <rt/vec3.hpp>

namespace answer {

rt::Vec3 reflect(rt::Vec3 incoming, rt::Vec3 normal);

}  // namespace answer

namespace rt {

using answer::reflect;

}  // namespace rt
