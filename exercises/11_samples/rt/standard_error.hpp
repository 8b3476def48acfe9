#pragma once
#include <cmath>
#include <numbers>
#include <rt/running_variance.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 11.2. How far the mean of the numbers so far is from the true mean, as a root mean
// square. Infinite with fewer than two numbers.
inline Real standard_error(const RunningVariance& known) {
    return rt::todo("11.2", known);
}

// The probability that a mean with this standard error lies within a distance of the true mean;
// both are 0 or more. It is that of the normal distribution, which holds for means of many numbers.
// Without an error it is 1, also at distance 0.
inline Real chance_within(Real distance, Real error) {
    return rt::todo("11.2", distance, error);
}

// How many numbers are needed, so that their mean has at most this standard error, 0 or more: at
// least 1, and never more than `most`.
inline std::int64_t samples_for(Real variance, Real error, std::int64_t most) {
    return rt::todo("11.2", variance, error, most);
}

}  // namespace rt
