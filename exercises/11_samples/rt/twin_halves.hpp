#pragma once
#include <cmath>
#include <numbers>
#include <rt/halves.hpp>
#include <rt/real.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 11.3. How many samples a part of the picture gets if the whole picture is to reach a
// mean square error of error^2 with as few samples as possible: spread * mean_spread / error^2,
// rounded up and kept within the limits. spread is the standard deviation of the part's samples,
// and mean_spread the mean of all parts' spreads; both are 0 or more. error is greater than 0 and
// finite.
// Star: a spread of 0 gets limits.least, whatever the mean is; otherwise an infinite spread or mean
// gets limits.most. The square of the error need not fit into a Real.
// Source: Neyman, "On the two different aspects of the representative method", 1934.
inline int worth_of(Real spread, Real mean_spread, Real error, CountLimits limits) {
    return rt::todo("11.3", spread, mean_spread, error, limits);
}

// How many samples of a part of the picture each half takes in all. What one half has seen, its
// spread and mean_spread, decides for the other half: neither half decides from its own samples how
// many it takes, so both means stay unbiased. The mean of both halves should have this error. Each
// half may then have sqrt(2) times that error, because the halves err almost independently.
inline Halves<int> crossed_counts(Halves<Real> spread, Halves<Real> mean_spread, Real error,
                                  CountLimits limits) {
    return rt::todo("11.3", spread, mean_spread, error, limits);
}

// The mean of both halves. Each half has the same weight, however many samples it took: the counts
// depend on what the halves have seen, so weights that depend on the counts would bring the bias
// back.
// Star: the result is finite if both means are finite.
inline Real twin_mean(Halves<Real> mean) {
    return rt::todo("11.3", mean);
}

// An estimate of the mean square error of twin_mean: the square of half the difference between the
// halves' means. It is unbiased if the halves err independently, and nearly so if their counts are
// crossed. For one part of the picture the estimate says little; its mean over many parts tells the
// error of the picture.
inline Real twin_square_error(Halves<Real> mean) {
    return rt::todo("11.3", mean);
}

}  // namespace rt
