#include <answer.hpp>
#include <any_random.hpp>
#include <rt/lambertian.hpp>
#include <rt/rng.hpp>

namespace answer EXPORTED {

std::optional<rt::Scatter> scatter_matte(rt::Color albedo, rt::Vec3 incoming, const rt::Hit& hit,
                                         rt::Rng& random) {
    return rt::scatter(rt::Lambertian{albedo}, incoming, hit, random);
}

std::optional<rt::Scatter> scatter_matte(rt::Color albedo, rt::Vec3 incoming, const rt::Hit& hit,
                                         checkpoint::AnyRandom& random) {
    return rt::scatter(rt::Lambertian{albedo}, incoming, hit, random);
}

}  // namespace EXPORTED
