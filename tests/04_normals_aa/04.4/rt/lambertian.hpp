#pragma once
#include <any_random.hpp>
#include <optional>
#include <rt/directions.hpp>
#include <rt/hit.hpp>
#include <rt/rng.hpp>
#include <rt/scatter.hpp>

namespace answer {

std::optional<rt::Scatter> scatter_matte(rt::Color albedo, rt::Vec3 incoming, const rt::Hit& hit,
                                         rt::Rng& random);
std::optional<rt::Scatter> scatter_matte(rt::Color albedo, rt::Vec3 incoming, const rt::Hit& hit,
                                         checkpoint::AnyRandom& random);

}  // namespace answer

namespace rt {

struct Lambertian {
    Color albedo;
};

template <class Random>
std::optional<Scatter> scatter(const Lambertian& material, Vec3 incoming, const Hit& hit,
                               Random& random) {
    checkpoint::AnyRandom any{random};
    return answer::scatter_matte(material.albedo, incoming, hit, any);
}
inline std::optional<Scatter> scatter(const Lambertian& material, Vec3 incoming, const Hit& hit,
                                      Rng& random) {
    return answer::scatter_matte(material.albedo, incoming, hit, random);
}

}  // namespace rt
