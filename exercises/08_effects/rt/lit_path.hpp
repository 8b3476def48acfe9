#pragma once
#include <optional>
#include <rt/ending.hpp>
#include <rt/place.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 08.4. Next-event estimation: one sample of the light that comes straight from a light
// to this place and leaves it toward the eye. lights.choose(place.point, random) chooses a light
// and a direction to it. Return black if it gives none, if place.density(that direction) is not
// greater than 0, or if sees_light says that something is in the way. Otherwise return the
// light's radiance times
//     density of the place / density of the sample * weight.
// If the path goes on, it may find the light itself, and the weight is shared_weight(density of the
// sample, density of the place); if not, the weight is 1. `ray` is the one that led here. Its type
// may carry more than a ray: so change its origin, to place.origin(direction), and its direction,
// and pass it on. Draw no random number of your own, and call sees_light at most once.
// Star: multiply by place.fog.gets_through(ray, distance), the share that gets through the fog.
template <class AnyRay, class World, class Lights, class Materials, class Medium, class Random>
Color direct_light(AnyRay ray, const World& world, const Lights& lights,
                   const Place<Materials, Medium>& place, bool goes_on, Random& random) {
    return rt::todo("08.4", ray, world, lights, place, goes_on, random);
}

// Exercise 08.4. The light that comes back along a ray: your loop of 04.7, in a scene that may have
// lights and fog. Four things change.
//   - next_place(ray, world, materials, fog, random) replaces world.hit, and place.scatter(random)
//     replaces materials(...); place.point, place.origin(direction) and place.is_sky() work for
//     surfaces and for fog.
//   - A second color holds the light that was collected so far. Every way out of the loop returns
//     it, plus what that way brings.
//   - A path that meets a light, place.light(lights), ends there and brings its radiance, weighted
//     by shared_weight(drawn, lights.density(that light, from)), where `drawn` is the density with
//     which the previous bounce drew its direction, and `from` is the point of that bounce. The
//     radiance counts in full if no light was sampled there: before the first bounce, and if drawn
//     is 0.
//   - At each bounce, unless lights.empty(): if place.density(the bounce's direction) is greater
//     than 0, add direct_light, times the throughput after this bounce's attenuation and before
//     the ending changes it. Its `goes_on` is true unless the path ends in the sky.
// The order matters, because random numbers are drawn: next_place, scatter, the ending (if it
// is called), direct_light. Without lights and fog the result is that of path_radiance, to
// the last bit.
template <class AnyRay, class World, class Materials, class Sky, class Lights, class Medium,
          class Ending, class Random>
Color lit_path_radiance(AnyRay ray, const World& world, const Materials& materials, const Sky& sky,
                        const Lights& lights, const Medium& fog, const Ending& ending, int depth,
                        Random& random) {
    return rt::todo("08.4", ray, world, materials, sky, lights, fog, ending, depth, random);
}

}  // namespace rt
