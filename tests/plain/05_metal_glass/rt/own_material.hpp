#pragma once
#include <optional>
#include <rt/above_horizon.hpp>
#include <rt/directions.hpp>
#include <rt/fresnel.hpp>
#include <rt/hit.hpp>
#include <rt/reflect.hpp>
#include <rt/scatter.hpp>

namespace rt {

struct OwnMaterial {
    Color color;
    Real amount = 0;
};

template <class Random>
std::optional<Scatter> scatter(const OwnMaterial& material, [[maybe_unused]] Vec3 incoming,
                               [[maybe_unused]] const Hit& hit, [[maybe_unused]] Random& random) {
    const Vec3 normal = facing_normal(hit);
    if (random.uniform() < material.amount / 2)
        return Scatter{{1, 1, 1}, above_horizon(reflect(incoming, normal), normal)};
    return Scatter{material.color, cosine_direction(normal, random_place(random))};
}

}  // namespace rt
