#pragma once
#include <cstdint>
#include <rt/real.hpp>

namespace rt {

// What is known about numbers that arrived one by one: how many there were, their mean, and the sum
// of their squared distances from that mean. Before the first number all three are 0. Each number
// may add a rounding error of epsilon times `squares`. In float, `squares` is accurate enough for
// up to a million numbers; after about 1 / epsilon numbers, it no longer grows.
struct RunningVariance {
    std::int64_t count = 0;
    Real mean = 0;
    Real squares = 0;
};

}  // namespace rt
