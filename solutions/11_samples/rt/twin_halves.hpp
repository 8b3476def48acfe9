#pragma once
#include <cmath>
#include <rt/real.hpp>

namespace rt {

// Something of each of two independent halves of the samples.
template <class T>
struct Halves {
    T first{}, second{};
};

// The fewest and the most samples that a place of the picture may get.
struct CountLimits {
    int least = 1, most = 1;
};

// How many samples a place of the picture is worth, so that the mean square error of the whole
// picture is error^2 and the work is least: in proportion to the place's spread, the standard
// deviation of its samples. mean_spread is the mean over all places. error is greater than 0; all
// may be infinite. Source: Neyman, "On the two different aspects of the representative method",
// 1934.
inline int worth_of(Real spread, Real mean_spread, Real error, CountLimits limits) {
    const Real wanted = spread == 0 ? Real(0) : std::ceil(spread / error * (mean_spread / error));
    if (!(wanted < static_cast<Real>(limits.most))) return limits.most;
    if (wanted < static_cast<Real>(limits.least)) return limits.least;
    return static_cast<int>(wanted);
}

// How many samples the two halves take of a place. What a half has seen decides for the other one:
// no number decides when its own mean is good enough, so both means stay unbiased. The mean of
// the two has then the error that is asked for.
inline Halves<int> crossed_counts(Halves<Real> spread, Halves<Real> mean_spread, Real error,
                                  CountLimits limits) {
    const Real of_each = error * std::sqrt(Real(2));
    return {worth_of(spread.second, mean_spread.second, of_each, limits),
            worth_of(spread.first, mean_spread.first, of_each, limits)};
}

// The mean of both halves. Each counts the same however many samples it took: these depend on the
// other's samples.
inline Real twin_mean(Halves<Real> mean) {
    return mean.first / 2 + mean.second / 2;
}

// The square of what the halves' mean is wrong by, on the average: the halves err independently.
inline Real twin_square_error(Halves<Real> mean) {
    const Real half = (mean.first - mean.second) / 2;
    return half * half;
}

}  // namespace rt
