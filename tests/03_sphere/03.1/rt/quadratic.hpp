#pragma once
#include <optional>
#include <rt/real.hpp>
#include <rt/roots.hpp>

namespace answer {

std::optional<rt::Roots> roots_from_discriminant(rt::Real a, rt::Real b, rt::Real c,
                                                 rt::Real discriminant);
std::optional<rt::Roots> solve_quadratic(rt::Real a, rt::Real b, rt::Real c);

}  // namespace answer

namespace rt {

using answer::roots_from_discriminant;
using answer::solve_quadratic;

}  // namespace rt
