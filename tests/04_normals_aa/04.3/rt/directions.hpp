#pragma once
#include <rt/rng.hpp>
#include <rt/vec2.hpp>
#include <rt/vec3.hpp>

namespace answer {

rt::Vec3 cosine_direction(rt::Vec3 normal, rt::Vec2 place);
rt::Vec2 random_place(rt::Rng& random);

}  // namespace answer

namespace rt {

using answer::cosine_direction;
using answer::random_place;

}  // namespace rt
