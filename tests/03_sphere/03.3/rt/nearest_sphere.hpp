#pragma once
#include <optional>
#include <rt/hit_sphere.hpp>
#include <rt/nearest.hpp>
#include <rt/scene_sphere.hpp>
#include <span>

namespace answer {

std::optional<rt::NearestSphere> nearest_sphere(std::span<const rt::SceneSphere> spheres,
                                                const rt::Ray& ray, rt::Interval within);

}  // namespace answer

namespace rt {

using answer::nearest_sphere;

}  // namespace rt
