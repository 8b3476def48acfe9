#pragma once
#include <optional>
#include <rt/above_horizon.hpp>
#include <rt/directions.hpp>
#include <rt/fresnel.hpp>
#include <rt/hit.hpp>
#include <rt/reflect.hpp>
#include <rt/scatter.hpp>

namespace rt {

// A material of your own. This one is a lacquer: a clear coat over a matte base.
struct OwnMaterial {
    Color color;      // of the base, each channel in [0, 1]
    Real amount = 0;  // how much of the base is coated, from 0 to 1
};

// The coat reflects like glass of index 1.5 and absorbs nothing. The light that it lets through
// comes back from the base. The random choice between the two already weights them.
template <class Random>
std::optional<Scatter> scatter(const OwnMaterial& material, [[maybe_unused]] Vec3 incoming,
                               [[maybe_unused]] const Hit& hit, [[maybe_unused]] Random& random) {
    const Vec3 normal = facing_normal(hit);
    const Real reflected =
        material.amount * fresnel_reflectance(-dot(incoming, normal), 1 / Real(1.5));
    if (random.uniform() < reflected)
        return Scatter{{1, 1, 1}, above_horizon(reflect(incoming, normal), normal)};
    return Scatter{material.color, cosine_direction(normal, random_place(random))};
}

}  // namespace rt
