#pragma once
#include <optional>
#include <rt/ending.hpp>
#include <rt/mesh_lights.hpp>
#include <rt/path_vertex.hpp>
#include <rt/rough_materials.hpp>
#include <rt/way_weight.hpp>

namespace rt {

// The lights of a scene, and the ways in which they may be found (given).
template <class Lights>
struct LightsByWays {
    Lights lamps;
    Ways ways = Ways::power;
};
using WayLights = LightsByWays<MeshLights>;

// Lights that include the sky (given): sky_density(direction) is the probability density, per solid
// angle, with which choose() takes a direction to it.
template <class Lights>
concept IncludesSky = requires(const Lights& lights, Vec3 direction) {
    lights.sky_density(direction);
};

// The weight of light that a bounce has found in the sky. `drawn` is the density of the bounce; 0
// if no sample could find what it meets.
template <class Lights>
Real sky_weight([[maybe_unused]] const Lights& lights, [[maybe_unused]] Ways ways,
                [[maybe_unused]] Real drawn, [[maybe_unused]] Vec3 direction) {
    if constexpr (IncludesSky<Lights>)
        if (drawn > 0) return way_weight(ways, Way::bounce, drawn, lights.sky_density(direction));
    return 1;
}

// The light of one lamp, chosen at random, that a vertex of a path scatters toward the eye (given):
// next-event estimation, as in 08.4, with the weight of 14.5. If the path ends here, no bounce can
// find the lamp, so the density of bounces is 0. attenuation(direction) is what of the light from
// there goes on, divided by the density of bounces.
template <class AnyRay, class World, class Lights, class Materials, class Medium, class Attenuation,
          class Random>
Color sampled_light(AnyRay ray, const World& world, const Lights& lights, Ways ways,
                    const PathVertex<Materials, Medium>& vertex, bool goes_on,
                    const Attenuation& attenuation, Random& random) {
    const std::optional<ChosenLight> chosen = lights.choose(vertex.point, random);
    if (!chosen) return {};
    const LightSample& sample = chosen->sample;
    const Real toward = vertex.shared_density(sample.direction);
    if (!(toward > 0)) return {};
    const Real weight = way_weight(ways, Way::sample, sample.density, goes_on ? toward : Real(0));
    if (weight == 0) return {};
    ray.origin = vertex.origin(sample.direction);
    ray.direction = sample.direction;
    if (!sees_light(world, ray, *chosen)) return {};
    const Real share = toward / sample.density * weight;
    return attenuation(sample.direction) *
           (share * vertex.fog.gets_through(ray, sample.distance) * chosen->radiance);
}

// The light that comes back along a ray (given): the loop of 08.4, for lamps of triangles and
// spheres. Both ways to find a lamp share its light by the weights of 14.5.
template <class AnyRay, class World, class Materials, class Sky, class Lights, class Medium,
          class Ending, class Random>
Color two_way_radiance(AnyRay ray, const World& world, const Materials& materials, const Sky& sky,
                       const Lights& lights, Ways ways, const Medium& fog, const Ending& ending,
                       int depth, Random& random) {
    Color throughput{1, 1, 1}, light;
    Vec3 from;
    Real drawn = 0;  // the density of the last bounce; 0 if no sample could find what it meets
    for (int bounces = 1;; ++bounces) {
        const auto vertex = next_vertex(ray, world, materials, fog, random);
        if (vertex.is_sky())
            return light + throughput * (sky_weight(lights, ways, drawn, ray.direction) *
                                         sky(ray.direction));
        if (const Light* const found = vertex.light(lights)) {
            const Real weight = drawn > 0 ? way_weight(ways, Way::bounce, drawn,
                                                       lights.density(*found, from, vertex.point))
                                          : Real(1);
            return light + throughput * (weight * found->radiance);
        }

        const std::optional<Scatter> bounce = vertex.scatter(random);
        if (!bounce) return light;
        const Color before = throughput;
        throughput *= bounce->attenuation;
        // What of the light from a direction reaches the eye.
        const auto arriving = [&](Vec3 direction) {
            return before * (vertex.collision
                                 ? bounce->attenuation
                                 : attenuation_from(materials, ray.direction, *vertex.hit,
                                                    direction, bounce->attenuation));
        };
        const PathEnd end = bounces < depth ? PathEnd::none : ending(throughput, random);
        drawn = vertex.shared_density(bounce->direction);
        if (drawn > 0)
            light += sampled_light(ray, world, lights, ways, vertex, end != PathEnd::in_sky,
                                   arriving, random);
        if (end == PathEnd::in_black || throughput == Color{}) return light;
        from = vertex.point;
        ray.origin = vertex.origin(bounce->direction);
        ray.direction = bounce->direction;
        if (end == PathEnd::in_sky) {
            // A sample has found the sky's light, too, and more exactly.
            if (IncludesSky<Lights> && drawn > 0) return light;
            return light + throughput * sky(ray.direction);
        }
    }
}

// What a renderer calls for a scene with these lights.
template <class AnyRay, class World, class Materials, class Sky, class Lights, class Medium,
          class Ending, class Random>
Color lit_path_radiance(const AnyRay& ray, const World& world, const Materials& materials,
                        const Sky& sky, const LightsByWays<Lights>& lights, const Medium& fog,
                        const Ending& ending, int depth, Random& random) {
    return two_way_radiance(ray, world, materials, sky, lights.lamps, lights.ways, fog, ending,
                            depth, random);
}

}  // namespace rt
