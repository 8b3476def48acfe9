#pragma once
#include <optional>
#include <rt/ending.hpp>
#include <rt/path_vertex.hpp>
#include <rt/shared_weight.hpp>

namespace rt {

template <class AnyRay, class World, class Lights, class Materials, class Medium, class Random>
Color direct_light(AnyRay ray, const World& world, const Lights& lights,
                   const PathVertex<Materials, Medium>& vertex, [[maybe_unused]] bool goes_on,
                   Random& random) {
    const std::optional<ChosenLight> chosen = lights.choose(vertex.point, random);
    if (!chosen) return {};
    const LightSample& sample = chosen->sample;
    const Real toward = vertex.density(sample.direction);
    if (!(toward > 0)) return {};
    ray.origin = vertex.origin(sample.direction);
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
        const auto vertex = next_vertex(ray, world, materials, fog, random);
        if (vertex.is_sky()) return light + throughput * sky(ray.direction);
        if (const Light* const found = vertex.light(lights))
            return sampled ? light : light + throughput * found->radiance;
        const std::optional<Scatter> bounce = vertex.scatter(random);
        if (!bounce) return light;
        throughput *= bounce->attenuation;
        const Color arriving = throughput;
        const PathEnd end = bounces < depth ? PathEnd::none : ending(throughput, random);
        if (!lights.empty()) {
            sampled = vertex.density(bounce->direction) > 0;
            if (sampled) light += arriving * direct_light(ray, world, lights, vertex, true, random);
        }
        if (end == PathEnd::in_black) return light;
        ray.origin = vertex.origin(bounce->direction);
        ray.direction = bounce->direction;
        if (end == PathEnd::in_sky) return light + throughput * sky(ray.direction);
    }
}

}  // namespace rt
