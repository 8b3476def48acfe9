#pragma once
#include <rt/basis.hpp>

namespace answer {

rt::Basis orthonormal_basis(const rt::Vec3& w);

}  // namespace answer

namespace rt {

using answer::orthonormal_basis;

}  // namespace rt
