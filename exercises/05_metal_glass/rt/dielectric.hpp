#pragma once
#include <optional>
#include <rt/above_horizon.hpp>
#include <rt/fresnel.hpp>
#include <rt/hit.hpp>
#include <rt/reflect.hpp>
#include <rt/refract.hpp>
#include <rt/scatter.hpp>
#include <rt/todo.hpp>

namespace rt {

// Clear glass, water or diamond: light is reflected or goes through, and none is lost.
struct Dielectric {
    Real index = Real(1.5);  // of refraction: inside divided by outside
};

// The same material with Schlick's reflectance instead of the exact one, for comparison.
struct SchlickDielectric {
    Real index = Real(1.5);
};

// Exercise 05.5. How a path goes on from the surface of glass: reflected with the probability
// reflectance(cosine, eta), otherwise refracted. Either way the path keeps all of its light,
// because the random choice already weights both. `incoming` has length 1; reflectance is one of
// the functions of exercise 05.4, or any other. At most one random number is drawn, and none if the
// reflectance is 0. The index may be below 1, like that of a bubble.
// Star: reflected light stays on its side of the surface, even if it grazes the surface: use
// above_horizon().
template <class Reflectance, class Random>
Scatter scatter_at_glass(Real index, Reflectance reflectance, Vec3 incoming, const Hit& hit,
                         Random& random) {
    return rt::todo("05.5", index, reflectance, incoming, hit, random);
}

// Given: the two materials differ only in the reflectance.
template <class Random>
std::optional<Scatter> scatter(const Dielectric& glass, Vec3 incoming, const Hit& hit,
                               Random& random) {
    return scatter_at_glass(glass.index, fresnel_reflectance, incoming, hit, random);
}
template <class Random>
std::optional<Scatter> scatter(const SchlickDielectric& glass, Vec3 incoming, const Hit& hit,
                               Random& random) {
    return scatter_at_glass(glass.index, schlick_reflectance, incoming, hit, random);
}

}  // namespace rt
