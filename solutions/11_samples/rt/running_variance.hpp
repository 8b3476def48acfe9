#pragma once
#include <cstdint>
#include <rt/known_numbers.hpp>
#include <rt/real.hpp>

namespace rt {

// Updates the count, mean and squares in `known` to include one more number. The numbers themselves
// are not stored. `squares` keeps its digits even if the numbers are far from 0 and close together
// (no cancellation). The number and its square are finite.
// Source: Welford, "Note on a method for calculating corrected sums of squares and products",
// Technometrics 1962.
inline void add(RunningVariance& known, Real number) {
    ++known.count;
    const Real before = number - known.mean;
    known.mean += before / static_cast<Real>(known.count);
    known.squares += before * (number - known.mean);
}

// The variance of the distribution that the numbers were drawn from, estimated without bias:
// squares / (count - 1), because the numbers are nearer to their own mean than to the true mean.
// Infinite with fewer than two numbers, which say nothing about the variance.
inline Real variance(const RunningVariance& known) {
    if (known.count < 2) return infinity;
    return known.squares / static_cast<Real>(known.count - 1);
}

}  // namespace rt
