#pragma once
#include <optional>
#include <rt/above_horizon.hpp>
#include <rt/hit.hpp>
#include <rt/reflect.hpp>
#include <rt/scatter.hpp>

namespace rt {

// Metal without fuzz (given). Nothing about it is random, so no random numbers are drawn for it.
struct Mirror {
    Color albedo;  // the share of light that comes back, each channel in [0, 1]
};

template <class Random>
std::optional<Scatter> scatter(const Mirror& material, Vec3 incoming, const Hit& hit,
                               Random& /*random*/) {
    const Vec3 normal = facing_normal(hit);
    return Scatter{material.albedo, above_horizon(reflect(incoming, normal), normal)};
}

}  // namespace rt
