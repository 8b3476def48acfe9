#pragma once
#include <cmath>
#include <numbers>
#include <rt/running_variance.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 11.2. The standard error of the mean: how far the mean of the numbers so far is from
// the true mean, as a root mean square. It is sqrt(variance / count), and infinite with fewer than
// two numbers.
inline Real standard_error(const RunningVariance& known) {
    return rt::todo("11.2", known);
}

// The probability that a mean with this standard error is at most `distance` from the true mean, on
// either side, according to the normal distribution, which describes means of many numbers:
// erf(distance / (sqrt(2) error)), with std::erf. distance is 0 or more and finite, and error is 0
// or more.
// Star: both may be as large or as small as a Real can be. If the error is 0, the probability is 1,
// even at distance 0; if the error is infinite, it is 0.
inline Real chance_within(Real distance, Real error) {
    return rt::todo("11.2", distance, error);
}

// How many numbers are needed for their mean to have at most this standard error: variance /
// error^2, rounded up, at least 1 and at most `most`, which is 1 or more. variance is 0 or more,
// and error is 0 or more and finite.
// Star: the variance may be infinite, and the square of the error need not fit into a Real. If the
// variance is 0, one number is enough, even for an error of 0. Otherwise the result is `most` if
// the error is 0 or the variance is infinite.
inline std::int64_t samples_for(Real variance, Real error, std::int64_t most) {
    return rt::todo("11.2", variance, error, most);
}

}  // namespace rt
