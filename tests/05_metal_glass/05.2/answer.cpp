#include <answer.hpp>
#include <any_random.hpp>
#include <rt/metal.hpp>
#include <rt/rng.hpp>

namespace answer EXPORTED {

rt::Real given_fuzz() {
    return rt::Metal{}.fuzz;
}

rt::Vec3 metal_direction(rt::Vec3 incoming, rt::Vec3 normal, rt::Real fuzz, rt::Vec2 place) {
    return rt::metal_direction(incoming, normal, fuzz, place);
}

std::optional<rt::Scatter> scatter_metal(rt::Color albedo, rt::Real fuzz, rt::Vec3 incoming,
                                         const rt::Hit& hit, rt::Rng& random) {
    return rt::scatter(rt::Metal{albedo, fuzz}, incoming, hit, random);
}

std::optional<rt::Scatter> scatter_metal(rt::Color albedo, rt::Real fuzz, rt::Vec3 incoming,
                                         const rt::Hit& hit, checkpoint::AnyRandom& random) {
    return rt::scatter(rt::Metal{albedo, fuzz}, incoming, hit, random);
}

}  // namespace EXPORTED
