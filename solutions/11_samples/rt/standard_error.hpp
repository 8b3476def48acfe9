#pragma once
#include <cmath>
#include <numbers>
#include <rt/running_variance.hpp>

namespace rt {

// How far the mean of the numbers so far is from the true mean, as a root mean square. Infinite
// with fewer than two numbers.
inline Real standard_error(const RunningVariance& known) {
    if (known.count < 2) return infinity;
    return std::sqrt(variance(known) / static_cast<Real>(known.count));
}

// The probability that a mean with this standard error lies within a distance of the true mean;
// both are 0 or more. It is that of the normal distribution, which holds for means of many numbers.
// Without an error it is 1, also at distance 0.
inline Real chance_within(Real distance, Real error) {
    if (error == 0) return 1;
    return std::erf(distance / error / std::numbers::sqrt2_v<Real>);
}

// How many numbers are needed, so that their mean has at most this standard error, 0 or more: at
// least 1, and never more than `most`.
inline std::int64_t samples_for(Real variance, Real error, std::int64_t most) {
    // Deviation by error first: neither square has to fit into a Real.
    const Real ratio = variance == 0 ? Real(0) : std::sqrt(variance) / error;
    const Real needed = std::ceil(ratio * ratio);
    if (!(needed < static_cast<Real>(most))) return most;
    return needed < 1 ? 1 : static_cast<std::int64_t>(needed);
}

}  // namespace rt
