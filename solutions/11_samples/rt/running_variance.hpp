#pragma once
#include <cstdint>
#include <limits>
#include <rt/real.hpp>

namespace rt {

// What is known of some numbers that come one by one: their mean, and the sum of their squared
// distances from it.
struct RunningVariance {
    std::int64_t count = 0;
    Real mean = 0;
    Real squares = 0;
};

// Takes one more number into account, in constant memory and without cancellation.
// Source: Welford, "Note on a method for calculating corrected sums of squares and products",
// Technometrics 1962.
inline void add(RunningVariance& known, Real number) {
    ++known.count;
    const Real before = number - known.mean;
    known.mean += before / static_cast<Real>(known.count);
    known.squares += before * (number - known.mean);
}

// The variance of what the numbers were drawn from, estimated without bias. Infinite with fewer
// than two numbers: they say nothing about it.
inline Real variance(const RunningVariance& known) {
    if (known.count < 2) return infinity;
    return known.squares / static_cast<Real>(known.count - 1);
}

}  // namespace rt
