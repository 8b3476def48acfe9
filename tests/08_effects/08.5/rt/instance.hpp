#pragma once
#include <optional>
#include <rt/bounds.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/interval.hpp>
#include <rt/placed_sphere.hpp>
#include <rt/surface_hit.hpp>

namespace answer {

rt::Ray object_ray(const rt::Instance& instance, const rt::Ray& ray);
std::optional<rt::Real> hit_instance(const rt::Instance& instance, const rt::Ray& ray,
                                     rt::Interval within);
rt::Hit surface_hit(const rt::Instance& instance, const rt::Ray& ray, rt::Real t);
rt::Box bounds_of(const rt::Instance& instance);

}  // namespace answer

namespace rt {

using answer::bounds_of;
using answer::hit_instance;
using answer::object_ray;
using answer::surface_hit;

}  // namespace rt
