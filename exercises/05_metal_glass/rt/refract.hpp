#pragma once
#include <cmath>
#include <optional>
#include <rt/cross.hpp>
#include <rt/length.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 05.3. The direction of light that arrives along `incoming` and passes through the
// surface. `normal` points to the side that the light comes from; both have length 1. eta is the
// index of refraction on that side divided by the index behind the surface, any number greater than
// 0. None if all light is reflected, which is when eta times the sine of the angle between
// `incoming` and the normal exceeds 1.
// Star: the sine of the angle behind is right within 4 epsilon, for the indices of real glass. If
// eta = 1, the direction stays as it is, bit for bit. Source: Snell's law.
inline std::optional<Vec3> refract(Vec3 incoming, Vec3 normal, Real eta) {
    return rt::todo("05.3", incoming, normal, eta);
}

}  // namespace rt
