#pragma once
#include <cstdint>
#include <rt/known_numbers.hpp>
#include <rt/real.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 11.1. Updates the count, mean and squares in `known` to include one more number. The
// numbers themselves are not stored.
// Star: `squares` keeps its digits even if the numbers are far from 0 and close together (no
// cancellation). The mean is off by at most (count + 4) epsilon / 2, and sqrt(squares / count) by
// at most 3 sqrt(count) epsilon, both in units of the numbers' largest absolute value. The number
// and its square are finite.
// Source: Welford, "Note on a method for calculating corrected sums of squares and products",
// Technometrics 1962.
inline void add(RunningVariance& known, Real number) {
    rt::todo("11.1", known, number);
}

// The variance of the distribution that the numbers were drawn from, estimated without bias:
// squares / (count - 1), because the numbers are nearer to their own mean than to the true mean.
// Infinite with fewer than two numbers, which say nothing about the variance.
inline Real variance(const RunningVariance& known) {
    return rt::todo("11.1", known);
}

}  // namespace rt
