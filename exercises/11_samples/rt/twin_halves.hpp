#pragma once
#include <cmath>
#include <numbers>
#include <rt/halves.hpp>
#include <rt/real.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 11.3. How many samples a place of the picture is worth if the mean square error of the
// whole picture is to be error^2 with the least work: spread * mean_spread / error^2, rounded
// up and kept within the limits. spread is the standard deviation of the place's samples,
// mean_spread is its mean over all places; both are 0 or more. error is greater than 0 and finite.
// Star: a spread of 0 gets limits.least, whatever the mean is; otherwise an infinite spread or mean
// gets limits.most. The square of the error need not fit into a Real.
// Source: Neyman, "On the two different aspects of the representative method", 1934.
inline int worth_of(Real spread, Real mean_spread, Real error, CountLimits limits) {
    return rt::todo("11.3", spread, mean_spread, error, limits);
}

// How many samples of a place each half takes in all. What one half has seen, spread and
// mean_spread, decides for the other half: no sample decides when its own mean is good enough, so
// both means stay unbiased. The mean of both halves is to have this error. Each half may then have
// sqrt(2) times that error, because the halves err independently.
inline Halves<int> crossed_counts(Halves<Real> spread, Halves<Real> mean_spread, Real error,
                                  CountLimits limits) {
    return rt::todo("11.3", spread, mean_spread, error, limits);
}

// The mean of both halves. Each counts the same, however many samples it took: weights that follow
// the counts would follow what the halves have seen, which would bring back a bias.
// Star: it is finite if both means are.
inline Real twin_mean(Halves<Real> mean) {
    return rt::todo("11.3", mean);
}

// An estimate of the mean square error of twin_mean: the square of half the difference of the
// halves. It is unbiased if the halves err independently, and nearly so if their counts are
// crossed. One place says little; the mean over many places says how wrong the picture is.
inline Real twin_square_error(Halves<Real> mean) {
    return rt::todo("11.3", mean);
}

}  // namespace rt
