#pragma once
#include <optional>
#include <rt/above_horizon.hpp>
#include <rt/fresnel.hpp>
#include <rt/hit.hpp>
#include <rt/reflect.hpp>
#include <rt/refract.hpp>
#include <rt/scatter.hpp>

namespace rt {

// Clear glass, water or diamond: light is reflected or goes through, and none is lost.
struct Dielectric {
    Real index = Real(1.5);  // of refraction: inside divided by outside
};

// The same material with Schlick's reflectance instead of the exact one, to compare the two.
struct SchlickDielectric {
    Real index = Real(1.5);
};

// How a path goes on from the surface of glass: reflected with the probability reflectance(cosine,
// eta), otherwise refracted. Either way the path keeps all of its light, because the random choice
// already weights both. `incoming` has length 1.
template <class Reflectance, class Random>
Scatter scatter_at_glass(Real index, Reflectance reflectance, Vec3 incoming, const Hit& hit,
                         Random& random) {
    const Real eta = hit.front ? 1 / index : index;
    const Vec3 normal = facing_normal(hit);
    const Real reflected = reflectance(-dot(incoming, normal), eta);
    // If nothing is reflected, no random number is drawn.
    const bool goes_through = !(reflected > 0 && random.uniform() < reflected);
    if (goes_through)
        if (const auto refracted = refract(incoming, normal, eta)) return {{1, 1, 1}, *refracted};
    return {{1, 1, 1}, above_horizon(reflect(incoming, normal), normal)};
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
