#pragma once
#include <rt/known_numbers.hpp>

namespace answer {

rt::Real standard_error(const rt::RunningVariance& known);
rt::Real chance_within(rt::Real distance, rt::Real error);
std::int64_t samples_for(rt::Real variance, rt::Real error, std::int64_t most);

}  // namespace answer

namespace rt {

using answer::chance_within;
using answer::samples_for;
using answer::standard_error;

}  // namespace rt
