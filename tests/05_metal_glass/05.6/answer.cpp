#include <answer.hpp>
#include <rt/own_material.hpp>

#include "types.hpp"

namespace answer EXPORTED {

std::optional<rt::Scatter> scatter_own(rt::Color color, rt::Real amount, rt::Vec3 incoming,
                                       const rt::Hit& hit, rt::Rng& random) {
    return rt::scatter(rt::OwnMaterial{color, amount}, incoming, hit, random);
}

std::optional<rt::Scatter> scatter_own(rt::Color color, rt::Real amount, rt::Vec3 incoming,
                                       const rt::Hit& hit, checkpoint::Extreme& random) {
    return rt::scatter(rt::OwnMaterial{color, amount}, incoming, hit, random);
}

}  // namespace EXPORTED
