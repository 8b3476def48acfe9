#pragma once
#include <optional>
#include <rt/vec3.hpp>

namespace answer {

std::optional<rt::Vec3> refract(rt::Vec3 incoming, rt::Vec3 normal, rt::Real eta);

}  // namespace answer

namespace rt {

using answer::refract;

}  // namespace rt
