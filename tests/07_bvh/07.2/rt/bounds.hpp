#pragma once
#include <rt/box.hpp>
#include <rt/sphere.hpp>

namespace answer {

rt::Box bounds_of(const rt::Sphere& sphere);
rt::Box join(const rt::Box& a, const rt::Box& b);

}  // namespace answer

namespace rt {

using answer::bounds_of;
using answer::join;

}  // namespace rt
