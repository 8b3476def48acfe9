#pragma once
#include <array>
#include <rt/vec3.hpp>

namespace answer {

rt::Vec3 smooth_normal(const std::array<rt::Vec3, 3>& normals, rt::Real u, rt::Real v,
                       rt::Vec3 flat);
rt::Vec3 bent_normal(rt::Vec3 smooth, rt::Vec3 flat, rt::Vec3 incoming);
rt::Vec3 keep_side(rt::Vec3 direction, rt::Vec3 smooth, rt::Vec3 flat);

}  // namespace answer

namespace rt {

using answer::bent_normal;
using answer::keep_side;
using answer::smooth_normal;

}  // namespace rt
