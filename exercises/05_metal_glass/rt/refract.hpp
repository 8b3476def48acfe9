#pragma once
#include <cmath>
#include <optional>
#include <rt/cross.hpp>
#include <rt/length.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 05.3. The direction of light that arrives along `incoming` and passes through the
// surface. `normal` points to the side that the light comes from; both have length 1. eta, greater
// than 0, is the index of refraction on that side divided by the index on the other side. None at
// total reflection: when eta times the sine of the angle between `incoming` and the normal exceeds
// 1.
// Star: the sine of the refraction angle is accurate to 4 epsilon, for the indices of real glass.
// If eta = 1, the direction stays as it is, bit for bit. Source: Snell's law.
inline std::optional<Vec3> refract(Vec3 incoming, Vec3 normal, Real eta) {
    return rt::todo("05.3", incoming, normal, eta);
}

}  // namespace rt
