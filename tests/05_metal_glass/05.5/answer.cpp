#include <answer.hpp>
#include <any_random.hpp>
#include <functional>
#include <rt/dielectric.hpp>
#include <rt/rng.hpp>

namespace answer EXPORTED {

rt::Real given_index() {
    return rt::Dielectric{}.index;
}

rt::Real given_schlick_index() {
    return rt::SchlickDielectric{}.index;
}

rt::Scatter scatter_at_glass(rt::Real index,
                             const std::function<rt::Real(rt::Real, rt::Real)>& reflectance,
                             rt::Vec3 incoming, const rt::Hit& hit, checkpoint::AnyRandom& random) {
    return rt::scatter_at_glass(index, reflectance, incoming, hit, random);
}

std::optional<rt::Scatter> scatter_glass(rt::Real index, rt::Vec3 incoming, const rt::Hit& hit,
                                         rt::Rng& random) {
    return rt::scatter(rt::Dielectric{index}, incoming, hit, random);
}

std::optional<rt::Scatter> scatter_glass(rt::Real index, rt::Vec3 incoming, const rt::Hit& hit,
                                         checkpoint::AnyRandom& random) {
    return rt::scatter(rt::Dielectric{index}, incoming, hit, random);
}

}  // namespace EXPORTED
