#pragma once
#include <functional>
#include <rt/color.hpp>
#include <rt/directions.hpp>
#include <rt/rng.hpp>

namespace answer {

rt::Vec2 jittered_offset(int cell, int n, rt::Vec2 place);
rt::Color pixel_average(int samples, rt::Rng& random,
                        const std::function<rt::Color(rt::Vec2)>& sample);

}  // namespace answer

namespace rt {

using answer::jittered_offset;
using answer::pixel_average;

}  // namespace rt
