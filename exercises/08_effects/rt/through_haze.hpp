#pragma once
#include <rt/haze.hpp>
#include <rt/todo.hpp>
#include <rt/transmittance.hpp>

namespace rt {

// Exercise 08.6. The color that gets to the eye. If the type AnyHaze has a member `density`, the
// share exp(-density * distance()) of `color` gets through, and haze.color makes up the rest.
// distance() is a search: ask once at most. It may be infinite. Where the density is 0, and for a
// type without that member, return `color` as it is, and do not ask: `if constexpr` alone compiles
// for both types.
// Star: of a bright lamp behind dense haze nothing is left, not even a rounding error.
template <class AnyHaze, class Distance>
Color through_haze(const AnyHaze& haze, Color color, const Distance& distance) {
    return rt::todo("08.6", haze, color, distance);
}

}  // namespace rt
