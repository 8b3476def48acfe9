#pragma once
#include <rt/real.hpp>

namespace rt {

// The weight of a sample of light (given), if there are two ways to find the light: `density` is
// the probability density with which one way chose the sample's direction, and `other` the density
// with which the other way would have chosen it. With these weights, light that both ways find
// counts once in total. Both densities are 0 or more, and not both are 0; one may be infinite.
// Source: the power heuristic of Veach and Guibas, "Optimally combining sampling techniques for
// Monte Carlo rendering", SIGGRAPH 1995.
inline Real shared_weight(Real density, Real other) {
    // Computed from the ratio, so that no square overflows.
    if (density < other) {
        const Real ratio = density / other;
        return ratio * ratio / (1 + ratio * ratio);
    }
    const Real ratio = other / density;
    return 1 / (1 + ratio * ratio);
}

}  // namespace rt
