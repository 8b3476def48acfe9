#pragma once
#include <optional>
#include <rt/ending.hpp>
#include <rt/path_vertex.hpp>
#include <rt/shared_weight.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 08.4. Next-event estimation: one sample of the light that comes straight from a light to
// this vertex of the path and goes on toward the eye, or black if none comes. The text has the
// steps. `ray` led to the vertex, and its type may have more members than Ray: change its origin
// and direction, and pass it to sees_light. Draw no random number of your own; call sees_light at
// most once.
// Star: multiply by vertex.fog.gets_through(ray, distance), the fraction that gets through the fog.
// If the path goes on, also multiply by shared_weight(density of the sample, density of the
// vertex). Here vertex.shared_density may replace vertex.density: it also covers rough metal.
template <class AnyRay, class World, class Lights, class Materials, class Medium, class Random>
Color direct_light(AnyRay ray, const World& world, const Lights& lights,
                   const PathVertex<Materials, Medium>& vertex, [[maybe_unused]] bool goes_on,
                   Random& random) {
    return rt::todo("08.4", ray, world, lights, vertex, goes_on, random);
}

// Exercise 08.4. The light that comes back along a ray: the loop of 04.7, in a scene that may have
// lights and fog. Fill both gaps, as the text says. Draw random numbers in this order: next_vertex,
// scatter, the ending (if it is called), direct_light. Without lights and fog the result is that of
// path_radiance, to the last bit.
// Star: if the path meets a light after a bounce at which a light was sampled, multiply that light
// by the bounce's weight, shared_weight(density of the bounce, lights.density(that light, the
// bounce's point)). `goes_on` is true unless the path ends in the sky.
template <class AnyRay, class World, class Materials, class Sky, class Lights, class Medium,
          class Ending, class Random>
Color lit_path_radiance(AnyRay ray, const World& world, const Materials& materials, const Sky& sky,
                        const Lights& lights, const Medium& fog, const Ending& ending, int depth,
                        Random& random) {
    // Delete this line when you have filled the gaps.
    rt::todo("08.4", ray, world, materials, sky, lights, fog, ending, depth, random);
    Color throughput{1, 1, 1}, light;  // `light` is what has been collected so far
    for (int bounces = 1;; ++bounces) {
        const auto vertex = next_vertex(ray, world, materials, fog, random);
        if (vertex.is_sky()) return light + throughput * sky(ray.direction);
        // Gap 1: the path may have met a light.

        const std::optional<Scatter> bounce = vertex.scatter(random);
        if (!bounce) return light;
        throughput *= bounce->attenuation;
        // Gap 2 begins here: copy the throughput before the ending changes it.
        const PathEnd end = bounces < depth ? PathEnd::none : ending(throughput, random);
        // Gap 2: direct light.

        if (end == PathEnd::in_black) return light;
        ray.origin = vertex.origin(bounce->direction);
        ray.direction = bounce->direction;
        if (end == PathEnd::in_sky) return light + throughput * sky(ray.direction);
    }
}

}  // namespace rt
