#pragma once
#include <any_random.hpp>
#include <functional>
#include <optional>
#include <rt/above_horizon.hpp>
#include <rt/hit.hpp>
#include <rt/reflect.hpp>
#include <rt/refract.hpp>
#include <rt/rng.hpp>
#include <rt/scatter.hpp>

namespace answer {

rt::Real given_index();
rt::Real given_schlick_index();
rt::Scatter scatter_at_glass(rt::Real index,
                             const std::function<rt::Real(rt::Real, rt::Real)>& reflectance,
                             rt::Vec3 incoming, const rt::Hit& hit, checkpoint::AnyRandom& random);
std::optional<rt::Scatter> scatter_glass(rt::Real index, rt::Vec3 incoming, const rt::Hit& hit,
                                         rt::Rng& random);
std::optional<rt::Scatter> scatter_glass(rt::Real index, rt::Vec3 incoming, const rt::Hit& hit,
                                         checkpoint::AnyRandom& random);

}  // namespace answer

namespace rt {

struct Dielectric {
    Real index = answer::given_index();
};

struct SchlickDielectric {
    Real index = answer::given_schlick_index();
};

template <class Reflectance, class Random>
Scatter scatter_at_glass(Real index, const Reflectance& reflectance, Vec3 incoming, const Hit& hit,
                         Random& random) {
    checkpoint::AnyRandom any{random};
    return answer::scatter_at_glass(index, reflectance, incoming, hit, any);
}

template <class Random>
std::optional<Scatter> scatter(const Dielectric& glass, Vec3 incoming, const Hit& hit,
                               Random& random) {
    checkpoint::AnyRandom any{random};
    return answer::scatter_glass(glass.index, incoming, hit, any);
}
inline std::optional<Scatter> scatter(const Dielectric& glass, Vec3 incoming, const Hit& hit,
                                      Rng& random) {
    return answer::scatter_glass(glass.index, incoming, hit, random);
}

}  // namespace rt
