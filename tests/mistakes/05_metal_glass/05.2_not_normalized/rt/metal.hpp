#pragma once
#include <optional>
#include <rt/above_horizon.hpp>
#include <rt/directions.hpp>
#include <rt/hit.hpp>
#include <rt/reflect.hpp>
#include <rt/scatter.hpp>

namespace rt {

struct Metal {
    Color albedo;   // the share of light that comes back, each channel in [0, 1]
    Real fuzz = 0;  // how far reflected light strays, in [0, 1]
};

inline Vec3 metal_direction(Vec3 incoming, Vec3 normal, Real fuzz, Vec2 place) {
    const Vec3 mirrored = reflect(incoming, normal);
    Vec3 v = mirrored + fuzz * uniform_direction(place);
    if (dot(v, normal) < 0) v = reflect(v, normal);
    return v;
}

template <class Random>
std::optional<Scatter> scatter(const Metal& material, Vec3 incoming, const Hit& hit,
                               Random& random) {
    return Scatter{material.albedo, metal_direction(incoming, facing_normal(hit), material.fuzz,
                                                    random_place(random))};
}

}  // namespace rt
