#pragma once
#include <rt/lens_and_haze.hpp>
#include <rt/todo.hpp>
#include <rt/transmittance.hpp>

namespace rt {

// Exercise 08.6. The color that gets to the eye. If the type AnyHaze has a member `density`, the
// fraction exp(-density * distance()) of `color` gets through, and haze.color makes up the rest.
// distance() is a search, so call it at most once; it may return infinity. If the density is 0 or
// the type has no such member, return `color` as it is, without calling distance(). Use `if
// constexpr`: a plain `if` does not compile for types without the member.
// Star: nothing is left of a bright lamp behind dense haze, not even a rounding error.
template <class AnyHaze, class Distance>
Color through_haze(const AnyHaze& haze, Color color, const Distance& distance) {
    return rt::todo("08.6", haze, color, distance);
}

}  // namespace rt
