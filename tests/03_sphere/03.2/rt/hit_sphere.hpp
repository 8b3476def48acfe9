#pragma once
#include <optional>
#include <rt/interval.hpp>
#include <rt/ray.hpp>
#include <rt/sphere.hpp>

namespace answer {

std::optional<rt::Real> hit_sphere(const rt::Sphere& sphere, const rt::Ray& ray,
                                   rt::Interval within);

}  // namespace answer

namespace rt {

using answer::hit_sphere;

}  // namespace rt
