#pragma once
#include <rt/portable.hpp>
#include <rt/real.hpp>

namespace rt {

// The share of light that gets through this length of fog or haze (given): exp(-density * length).
// Source: Bouguer, "Essai d'optique", 1729; known as Beer's law.
inline Real transmittance(Real density, Real length) {
    return portable::exp(-density * length);
}

}  // namespace rt
