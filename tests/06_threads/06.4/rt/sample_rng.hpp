#pragma once
#include <cstdint>
#include <functional>
#include <rt/color.hpp>
#include <rt/rng.hpp>

namespace answer {

rt::Rng sample_rng(std::uint64_t seed, int x, int y, int sample);
rt::Color average_samples(std::uint64_t seed, int x, int y, int samples,
                          const std::function<rt::Color(int, rt::Rng&)>& draw);

}  // namespace answer

namespace rt {

using answer::average_samples;
using answer::sample_rng;

}  // namespace rt
