#pragma once
#include <optional>
#include <rt/directions.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/light_sample.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/sphere.hpp>

namespace answer {

rt::Real cone_height(rt::Real radius, rt::Real distance);
rt::Real light_density(const rt::Sphere& light, rt::Vec3 from);
std::optional<rt::LightSample> sample_light(const rt::Sphere& light, rt::Vec3 from, rt::Vec2 place);

}  // namespace answer

namespace rt {

using answer::cone_height;
using answer::light_density;
using answer::sample_light;

}  // namespace rt
