#pragma once
// Ways to add up numbers, each compiled twice: as the floating-point standard requires, and with
// -ffast-math.

#include <cstddef>
#include <rt/real.hpp>

namespace toolchain {

using rt::Real;

using Sum = Real (*)(const Real* terms, std::size_t count);

struct Sums {
    Sum naive, pairwise, compensated;
};

Sums strict_sums();     // study_strict_sums.cpp
Sums fast_math_sums();  // study_fast_math_sums.cpp

}  // namespace toolchain
