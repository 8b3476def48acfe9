#pragma once
#include <optional>
#include <rt/ending.hpp>
#include <rt/path_vertex.hpp>
#include <rt/shared_weight.hpp>

namespace rt {

// Next-event estimation: the light that comes straight from one of the lights, chosen at random,
// and that this vertex of the path scatters toward the eye. `ray` provides what a ray has besides
// an origin and a direction. Star: if the path goes on, it may find the light by itself, and the
// two samples share the light according to their weights. In the core there are no weights: a light
// that a path finds counts in full where no light was sampled, and otherwise not at all.
template <class AnyRay, class World, class Lights, class Materials, class Medium, class Random>
Color direct_light(AnyRay ray, const World& world, const Lights& lights,
                   const PathVertex<Materials, Medium>& vertex, [[maybe_unused]] bool goes_on,
                   Random& random) {
    const std::optional<ChosenLight> chosen = lights.choose(vertex.point, random);
    if (!chosen) return {};
    const LightSample& sample = chosen->sample;
    const Real toward = vertex.shared_density(sample.direction);
    if (!(toward > 0)) return {};
    ray.origin = vertex.origin(sample.direction);
    ray.direction = sample.direction;
    if (!sees_light(world, ray, *chosen)) return {};
    const Real weight = goes_on ? shared_weight(sample.density, toward) : Real(1);
    const Real share =
        toward / sample.density * weight * vertex.fog.gets_through(ray, sample.distance);
    return share * chosen->radiance;
}

// The light that comes back along a ray in a scene with lights, with fog, or with both. It is
// path_radiance of chapter 04, but also collects light on the way. If all paths end in black, a
// little light is missing: at the last place, the sample of a light is weighted as if the bounce
// were followed, but it is not. With endings in the sky, and with roulette, the result is right.
template <class AnyRay, class World, class Materials, class Sky, class Lights, class Medium,
          class Ending, class Random>
Color lit_path_radiance(AnyRay ray, const World& world, const Materials& materials, const Sky& sky,
                        const Lights& lights, const Medium& fog, const Ending& ending, int depth,
                        Random& random) {
    Color throughput{1, 1, 1}, light;
    // Where the ray comes from, and the density with which its direction was drawn. The density is
    // 0 if no light was sampled; then a light that the path finds counts in full.
    Vec3 from;
    Real drawn = 0;
    for (int bounces = 1;; ++bounces) {
        const auto vertex = next_vertex(ray, world, materials, fog, random);
        if (vertex.is_sky()) return light + throughput * sky(ray.direction);
        if (const Light* const found = vertex.light(lights)) {
            const Real weight =
                drawn > 0 ? shared_weight(drawn, lights.density(*found, from)) : Real(1);
            return light + throughput * (weight * found->radiance);
        }

        const std::optional<Scatter> bounce = vertex.scatter(random);
        if (!bounce) return light;
        throughput *= bounce->attenuation;
        const Color arriving = throughput;  // the share of light from here that reaches the eye
        const PathEnd end = bounces < depth ? PathEnd::none : ending(throughput, random);
        if (!lights.empty()) {
            drawn = vertex.shared_density(bounce->direction);
            if (drawn > 0)
                light += arriving *
                         direct_light(ray, world, lights, vertex, end != PathEnd::in_sky, random);
        }
        if (end == PathEnd::in_black) return light;
        from = vertex.point;
        ray.origin = vertex.origin(bounce->direction);
        ray.direction = bounce->direction;
        if (end == PathEnd::in_sky) return light + throughput * sky(ray.direction);
    }
}

}  // namespace rt
