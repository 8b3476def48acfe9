#pragma once
#include <rt/mat4.hpp>
#include <rt/transform.hpp>

namespace answer {

rt::Mat4 inverse(const rt::Mat4& m);
rt::Vec3 to_object(const rt::Mat4& object_to_world, const rt::Vec3& world_point);
rt::Vec3 to_world(const rt::Mat4& object_to_world, const rt::Vec3& object_point);

}  // namespace answer

namespace rt {

using answer::inverse;
using answer::to_object;
using answer::to_world;

}  // namespace rt
