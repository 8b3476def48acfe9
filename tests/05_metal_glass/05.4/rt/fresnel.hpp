#pragma once
#include <optional>
#include <rt/real.hpp>

namespace answer {

std::optional<rt::Real> refracted_cosine(rt::Real cosine, rt::Real eta);
rt::Real fresnel_reflectance(rt::Real cosine, rt::Real eta);
rt::Real schlick_reflectance(rt::Real cosine, rt::Real eta);

}  // namespace answer

namespace rt {

using answer::fresnel_reflectance;
using answer::refracted_cosine;
using answer::schlick_reflectance;

}  // namespace rt
