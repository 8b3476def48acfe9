#pragma once
#include <rt/real.hpp>
#include <rt/ways.hpp>

namespace rt {

// The plain answer: the formulas as they stand in the text.
inline Real way_weight(Ways ways, Way found_by, Real density, Real other) {
    if (other == 0) return 1;
    if (ways == Ways::samples) return found_by == Way::sample ? Real(1) : Real(0);
    if (ways == Ways::bounces) return found_by == Way::bounce ? Real(1) : Real(0);
    if (ways == Ways::balance) return density / (density + other);
    return density * density / (density * density + other * other);
}

}  // namespace rt
