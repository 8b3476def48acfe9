#pragma once
#include <any_random.hpp>
#include <optional>
#include <rt/above_horizon.hpp>
#include <rt/directions.hpp>
#include <rt/hit.hpp>
#include <rt/reflect.hpp>
#include <rt/rng.hpp>
#include <rt/scatter.hpp>
#include <rt/uniform_direction.hpp>

namespace answer {

rt::Real given_fuzz();
rt::Vec3 metal_direction(rt::Vec3 incoming, rt::Vec3 normal, rt::Real fuzz, rt::Vec2 place);
std::optional<rt::Scatter> scatter_metal(rt::Color albedo, rt::Real fuzz, rt::Vec3 incoming,
                                         const rt::Hit& hit, rt::Rng& random);
std::optional<rt::Scatter> scatter_metal(rt::Color albedo, rt::Real fuzz, rt::Vec3 incoming,
                                         const rt::Hit& hit, checkpoint::AnyRandom& random);

}  // namespace answer

namespace rt {

struct Metal {
    Color albedo;
    Real fuzz = answer::given_fuzz();
};

using answer::metal_direction;

template <class Random>
std::optional<Scatter> scatter(const Metal& material, Vec3 incoming, const Hit& hit,
                               Random& random) {
    checkpoint::AnyRandom any{random};
    return answer::scatter_metal(material.albedo, material.fuzz, incoming, hit, any);
}
inline std::optional<Scatter> scatter(const Metal& material, Vec3 incoming, const Hit& hit,
                                      Rng& random) {
    return answer::scatter_metal(material.albedo, material.fuzz, incoming, hit, random);
}

}  // namespace rt
