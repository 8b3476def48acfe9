#pragma once
#include <cstdint>
#include <limits>
#include <rt/real.hpp>
#include <rt/todo.hpp>

namespace rt {

// What is known of some numbers that come one by one: their mean, and the sum of their squared
// distances from it.
struct RunningVariance {
    std::int64_t count = 0;
    Real mean = 0;
    Real squares = 0;
};

// Exercise 11.1. Takes one more number into account, in constant memory and without cancellation.
// Source: Welford, "Note on a method for calculating corrected sums of squares and products",
// Technometrics 1962.
inline void add(RunningVariance& known, Real number) {
    rt::todo("11.1", known, number);
}

// The variance of what the numbers were drawn from, estimated without bias. Infinite with fewer
// than two numbers: they say nothing about it.
inline Real variance(const RunningVariance& known) {
    return rt::todo("11.1", known);
}

}  // namespace rt
