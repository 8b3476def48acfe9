#pragma once
#include <optional>
#include <rt/above_horizon.hpp>
#include <rt/fresnel.hpp>
#include <rt/hit.hpp>
#include <rt/reflect.hpp>
#include <rt/refract.hpp>
#include <rt/scatter.hpp>

namespace rt {

struct Dielectric {
    Real index = Real(1.5);
};

struct SchlickDielectric {
    Real index = Real(1.5);
};

template <class Reflectance, class Random>
Scatter scatter_at_glass(Real index, Reflectance reflectance, Vec3 incoming, const Hit& hit,
                         Random& random) {
    const Real eta = hit.front ? 1 / index : index;
    const Vec3 normal = facing_normal(hit);
    const Real reflected = reflectance(-dot(incoming, normal), eta);
    if (!(reflected > 0 && random.uniform() < reflected))
        if (const auto refracted = refract(incoming, normal, eta)) return {{1, 1, 1}, *refracted};
    return {{1, 1, 1}, reflect(incoming, normal)};
}

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
