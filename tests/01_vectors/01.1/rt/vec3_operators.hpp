#pragma once
#include <rt/vec3_type.hpp>

namespace answer {

// By reference, so that an answer that changes its operands changes the checkpoint's.
rt::Vec3 operator+(const rt::Vec3& a, const rt::Vec3& b);
rt::Vec3 operator-(const rt::Vec3& a, const rt::Vec3& b);
rt::Vec3 operator*(const rt::Vec3& v, rt::Real s);
rt::Vec3 operator/(const rt::Vec3& v, rt::Real s);

}  // namespace answer

namespace rt {

using answer::operator+;
using answer::operator-;
using answer::operator*;
using answer::operator/;

}  // namespace rt
