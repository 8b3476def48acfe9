#pragma once
#include <rt/basis.hpp>

namespace answer {

rt::Basis look_at(const rt::Vec3& from, const rt::Vec3& at, const rt::Vec3& up);

}  // namespace answer

namespace rt {

using answer::look_at;

}  // namespace rt
