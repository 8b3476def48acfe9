#pragma once
#include <rt/halves.hpp>
#include <rt/real.hpp>

namespace answer {

int worth_of(rt::Real spread, rt::Real mean_spread, rt::Real error, rt::CountLimits limits);
rt::Halves<int> crossed_counts(rt::Halves<rt::Real> spread, rt::Halves<rt::Real> mean_spread,
                               rt::Real error, rt::CountLimits limits);
rt::Real twin_mean(rt::Halves<rt::Real> mean);
rt::Real twin_square_error(rt::Halves<rt::Real> mean);

}  // namespace answer

namespace rt {

using answer::crossed_counts;
using answer::twin_mean;
using answer::twin_square_error;
using answer::worth_of;

}  // namespace rt
