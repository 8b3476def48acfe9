#pragma once
#include <rt/hit.hpp>

namespace answer {

rt::Vec3 leave_surface(const rt::Hit& hit, rt::Vec3 direction);

}  // namespace answer

namespace rt {

using answer::leave_surface;

}  // namespace rt
