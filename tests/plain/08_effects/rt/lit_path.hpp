#pragma once
#include <optional>
#include <rt/ending.hpp>
#include <rt/place.hpp>
#include <rt/shared_weight.hpp>

namespace rt {

template <class AnyRay, class World, class Lights, class Materials, class Medium, class Random>
Color direct_light(AnyRay ray, const World& world, const Lights& lights,
                   const Place<Materials, Medium>& place, [[maybe_unused]] bool goes_on,
                   Random& random) {
    const std::optional<ChosenLight> chosen = lights.choose(place.point, random);
    if (!chosen) return {};
    const LightSample& sample = chosen->sample;
    const Real toward = place.density(sample.direction);
    if (!(toward > 0)) return {};
    ray.origin = place.origin(sample.direction);
    ray.direction = sample.direction;
    if (!sees_light(world, ray, *chosen)) return {};
    return toward / sample.density * chosen->radiance;
}

template <class AnyRay, class World, class Materials, class Sky, class Lights, class Medium,
          class Ending, class Random>
Color lit_path_radiance(AnyRay ray, const World& world, const Materials& materials, const Sky& sky,
                        const Lights& lights, const Medium& fog, const Ending& ending, int depth,
                        Random& random) {
    Color throughput{1, 1, 1}, light;
    bool sampled = false;
    for (int bounces = 1;; ++bounces) {
        const auto place = next_place(ray, world, materials, fog, random);
        if (place.is_sky()) return light + throughput * sky(ray.direction);
        if (const Light* const found = place.light(lights))
            return sampled ? light : light + throughput * found->radiance;
        const std::optional<Scatter> bounce = place.scatter(random);
        if (!bounce) return light;
        throughput *= bounce->attenuation;
        const Color arriving = throughput;
        const PathEnd end = bounces < depth ? PathEnd::none : ending(throughput, random);
        if (!lights.empty()) {
            sampled = place.density(bounce->direction) > 0;
            if (sampled) light += arriving * direct_light(ray, world, lights, place, true, random);
        }
        if (end == PathEnd::in_black) return light;
        ray.origin = place.origin(bounce->direction);
        ray.direction = bounce->direction;
        if (end == PathEnd::in_sky) return light + throughput * sky(ray.direction);
    }
}

}  // namespace rt
