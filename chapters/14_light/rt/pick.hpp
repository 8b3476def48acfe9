#pragma once
#include <cstddef>
#include <rt/real.hpp>

namespace rt {

// An entry of a table, chosen at random (given).
struct Pick {
    std::size_t index = 0;
    Real probability = 0;  // of this entry; 0 if there was none to choose
    Real rest = 0;  // where in the entry's part of [0, 1) the random number lies, 0 <= rest < 1
};

}  // namespace rt
