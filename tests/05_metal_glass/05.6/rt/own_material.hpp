#pragma once
#include <optional>
#include <rt/hit.hpp>
#include <rt/scatter.hpp>

#include "../types.hpp"

namespace answer {

std::optional<rt::Scatter> scatter_own(rt::Color color, rt::Real amount, rt::Vec3 incoming,
                                       const rt::Hit& hit, rt::Rng& random);
std::optional<rt::Scatter> scatter_own(rt::Color color, rt::Real amount, rt::Vec3 incoming,
                                       const rt::Hit& hit, checkpoint::Extreme& random);

}  // namespace answer

namespace rt {

struct OwnMaterial {
    Color color;
    Real amount = 0;
};

template <class Random>
std::optional<Scatter> scatter(const OwnMaterial& material, Vec3 incoming, const Hit& hit,
                               Random& random) {
    return answer::scatter_own(material.color, material.amount, incoming, hit, random);
}

}  // namespace rt
