#pragma once
#include <rt/real.hpp>

namespace rt {

// The two real solutions of a quadratic equation, low <= high. They may coincide.
struct Roots {
    Real low = 0, high = 0;
};

}  // namespace rt
