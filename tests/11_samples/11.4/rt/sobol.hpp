#pragma once
#include <rt/fixed_point.hpp>

namespace answer {

std::uint32_t reversed_bits(std::uint32_t x);
rt::FixedPoint2 sobol_point(std::uint32_t index);
std::uint32_t owen_scrambled(std::uint32_t fraction, std::uint32_t seed);

}  // namespace answer

namespace rt {

using answer::owen_scrambled;
using answer::reversed_bits;
using answer::sobol_point;

}  // namespace rt
