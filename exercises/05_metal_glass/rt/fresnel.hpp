#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <rt/real.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 05.4. In all three functions, `cosine`, in [0, 1], is the cosine of the angle between
// the normal and the light that arrives. eta, greater than 0, is the index of refraction on the
// side that the light comes from, divided by the index on the other side.
// Star: a cosine that rounding has put above 1 counts as 1. No digits are lost, however close eta
// is to 1, except close to the critical angle: each result is off by at most rounding_bound(50) *
// (1 + (eta cosine / c)^2), where c is the cosine of the refraction angle; Schlick's reflectance
// may be off by five times as much. The exact reflectance is 0 for eta = 1.

// The cosine of the refraction angle. None at total reflection.
inline std::optional<Real> refracted_cosine(Real cosine, Real eta) {
    return rt::todo("05.4", cosine, eta);
}

// The fraction of unpolarized light that is reflected, in [0, 1]; 1 at total reflection.
// Source: Fresnel's equations.
inline Real fresnel_reflectance(Real cosine, Real eta) {
    return rt::todo("05.4", cosine, eta);
}

// The same fraction by Schlick's approximation, with the cosine on the side of the smaller index,
// so that the reflectance is the same from both sides of a surface, and 1 where total reflection
// begins.
// Source: Schlick, "An inexpensive BRDF model for physically-based rendering", 1994.
inline Real schlick_reflectance(Real cosine, Real eta) {
    return rt::todo("05.4", cosine, eta);
}

}  // namespace rt
