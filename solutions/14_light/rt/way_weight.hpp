#pragma once
#include <rt/real.hpp>
#include <rt/ways.hpp>

namespace rt {

// The weight of light that one of two ways has found in a direction. `density` is the probability
// density with which this way chooses the direction, and `other` that of the other way. Both are 0
// or more; one of them may be infinite. If the other way never chooses the direction (0), the
// weight is 1. The weights of both ways add up to 1, within epsilon.
inline Real way_weight(Ways ways, Way found_by, Real density, Real other) {
    if (!(other > 0)) return 1;
    if (ways == Ways::samples) return found_by == Way::sample ? Real(1) : Real(0);
    if (ways == Ways::bounces) return found_by == Way::bounce ? Real(1) : Real(0);
    // The formulas, with numerator and denominator divided by the density. The ratio may be
    // infinite; then the weight is 0.
    const Real ratio = other / density;
    return 1 / (1 + (ways == Ways::power ? ratio * ratio : ratio));
}

}  // namespace rt
