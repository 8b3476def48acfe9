#pragma once
#include <cmath>
#include <optional>
#include <rt/cross.hpp>
#include <rt/length.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 05.3. Where light goes that arrives along `incoming` and enters what lies behind the
// surface. `normal` points to the side that the light comes from; both have length 1. eta is the
// index of refraction there divided by the one behind, any number greater than 0. The sine of the
// angle behind is right within 4 epsilon, for the indices of real glass. None where all light is
// reflected: where eta times the sine of the angle to the normal exceeds 1. With eta = 1 the
// direction stays as it is, bit for bit. Source: Snell's law.
inline std::optional<Vec3> refract(Vec3 incoming, Vec3 normal, Real eta) {
    return rt::todo("05.3", incoming, normal, eta);
}

}  // namespace rt
