#pragma once
#include <cmath>
#include <rt/real.hpp>
#include <rt/todo.hpp>

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

// Exercise 11.3. How many samples a place of the picture is worth, so that the mean square error of
// the whole picture is error^2 and the work is least: in proportion to the place's spread, the
// standard deviation of its samples. mean_spread is the mean over all places. error is greater than
// 0; all may be infinite. Source: Neyman, "On the two different aspects of the representative
// method", 1934.
inline int worth_of(Real spread, Real mean_spread, Real error, CountLimits limits) {
    return rt::todo("11.3", spread, mean_spread, error, limits);
}

// How many samples the two halves take of a place. What a half has seen decides for the other one:
// no number decides when its own mean is good enough, so both means stay unbiased. The mean of
// the two has then the error that is asked for.
inline Halves<int> crossed_counts(Halves<Real> spread, Halves<Real> mean_spread, Real error,
                                  CountLimits limits) {
    return rt::todo("11.3", spread, mean_spread, error, limits);
}

// The mean of both halves. Each counts the same however many samples it took: these depend on the
// other's samples.
inline Real twin_mean(Halves<Real> mean) {
    return rt::todo("11.3", mean);
}

// The square of what the halves' mean is wrong by, on the average: the halves err independently.
inline Real twin_square_error(Halves<Real> mean) {
    return rt::todo("11.3", mean);
}

}  // namespace rt
