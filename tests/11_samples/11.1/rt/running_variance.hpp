#pragma once
#include <rt/known_numbers.hpp>

namespace answer {

void add(rt::RunningVariance& known, rt::Real number);
rt::Real variance(const rt::RunningVariance& known);

}  // namespace answer

namespace rt {

using answer::add;
using answer::variance;

}  // namespace rt
