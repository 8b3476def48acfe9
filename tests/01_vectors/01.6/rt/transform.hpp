#pragma once
#include <rt/mat4.hpp>

namespace answer {

rt::Vec3 transform_point(const rt::Mat4& m, const rt::Vec3& p);
rt::Vec3 transform_vector(const rt::Mat4& m, const rt::Vec3& v);
rt::Vec3 transform_normal(const rt::Mat4& inverse, const rt::Vec3& n);
rt::Mat4 multiply(const rt::Mat4& a, const rt::Mat4& b);

}  // namespace answer

namespace rt {

using answer::multiply;
using answer::transform_normal;
using answer::transform_point;
using answer::transform_vector;

}  // namespace rt
