#pragma once
#include <cmath>
#include <optional>
#include <rt/above_horizon.hpp>
#include <rt/directions.hpp>
#include <rt/fresnel.hpp>
#include <rt/hit.hpp>
#include <rt/reflect.hpp>
#include <rt/refract.hpp>
#include <rt/scatter.hpp>
#include <rt/todo.hpp>
#include <rt/uniform_direction.hpp>

namespace rt {

// A material of your own (given). You choose what its two members mean; a scene file sets them.
struct OwnMaterial {
    Color color;      // each channel in [0, 1]
    Real amount = 0;  // in [0, 1]
};

// Exercise 05.6. How a path goes on from the material that you invent; return {} if the light is
// absorbed. `incoming` has length 1. Light may arrive on both sides of the surface. Any design that
// obeys the six rules of the text passes. [[maybe_unused]] keeps the compiler from warning about an
// argument that a design does not use.
// Star: the rules also hold for light that grazes the surface, for hits of any size, and for the
// smallest and the largest random numbers.
template <class Random>
std::optional<Scatter> scatter(const OwnMaterial& material, [[maybe_unused]] Vec3 incoming,
                               [[maybe_unused]] const Hit& hit, [[maybe_unused]] Random& random) {
    return rt::todo("05.6", material, incoming, hit, random);
}

}  // namespace rt
