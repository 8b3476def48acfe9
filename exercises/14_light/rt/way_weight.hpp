#pragma once
#include <rt/real.hpp>
#include <rt/todo.hpp>
#include <rt/ways.hpp>

namespace rt {

// Exercise 14.5. The weight of light that one of two ways, `found_by`, has found in a direction.
// `density` is the density with which this way chooses the direction, and `other` that of the other
// way. If the other way never chooses it (0), the weight is 1. Otherwise: Ways::samples and
// Ways::bounces give 1 to light that this way has found, and 0 to light of the other. With
// p = density and q = other, Ways::balance gives p / (p + q), and Ways::power p^2 / (p^2 + q^2).
// Star: one of the densities may be infinite, and the square of a density may overflow or
// underflow; the result is never NaN, and the weights of both ways add up to 1 within epsilon.
// Source: Veach and Guibas, "Optimally combining sampling techniques for Monte Carlo rendering",
// SIGGRAPH 1995.
inline Real way_weight(Ways ways, Way found_by, Real density, Real other) {
    return rt::todo("14.5", ways, found_by, density, other);
}

}  // namespace rt
