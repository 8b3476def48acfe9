#pragma once
#include <cmath>
#include <numbers>
#include <rt/running_variance.hpp>

namespace rt {

// The standard error of the mean: the root mean square distance between the mean of the numbers so
// far and the true mean. It is sqrt(variance / count), and infinite with fewer than two numbers.
inline Real standard_error(const RunningVariance& known) {
    // With fewer than two numbers the variance is infinite, and remains so when divided by 0 or 1.
    return std::sqrt(variance(known) / static_cast<Real>(known.count));
}

// The probability that a mean with this standard error is at most `distance` from the true mean, on
// either side, according to the normal distribution, which describes means of many numbers:
// erf(distance / (sqrt(2) error)), with std::erf. distance is 0 or more and finite, and error is 0
// or more; both may be as large or as small as a Real can be. If the error is 0, the probability is
// 1, even at distance 0; if the error is infinite, it is 0.
inline Real chance_within(Real distance, Real error) {
    if (error == 0) return 1;
    return std::erf(distance / error / std::numbers::sqrt2_v<Real>);
}

// How many numbers are needed for their mean to have at most this standard error: variance /
// error^2, rounded up, at least 1 and at most `most`. variance is 0 or more and may be infinite;
// error is 0 or more and finite, and its square need not fit into a Real; most is 1 or more. If the
// variance is 0, one number is enough, even for an error of 0. Otherwise the result is `most` if
// the error is 0 or the variance is infinite.
inline std::int64_t samples_for(Real variance, Real error, std::int64_t most) {
    // Divides twice: if the first quotient overflows or underflows, the second would as well.
    const Real needed = variance == 0 ? Real(0) : std::ceil(variance / error / error);
    if (!(needed < static_cast<Real>(most))) return most;
    return needed < 1 ? 1 : static_cast<std::int64_t>(needed);
}

}  // namespace rt
