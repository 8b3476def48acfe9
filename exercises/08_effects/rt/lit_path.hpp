#pragma once
#include <optional>
#include <rt/ending.hpp>
#include <rt/place.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 08.4. Next-event estimation: one sample of the light that comes straight from a light to
// this place and leaves it towards the eye. lights.choose(place.point, random) chooses a light and
// a direction to it; black where it gives none, where place.density(that direction) is not greater
// than 0, and where sees_light says that something is in the way. Otherwise the light's radiance
// times
//     density of the place / density of the sample * weight * what gets through the fog,
// where the fog is place.fog.gets_through(ray, distance). The weight is shared_weight(density of
// the sample, density of the place) where the path goes on, as it may find the light itself, and 1
// where it does not. `ray` is the one that led here: its type carries more than a ray, so change
// its origin, to place.origin(direction), and its direction, and ask with that. Draw no random
// number of your own, and ask sees_light at most once.
template <class AnyRay, class World, class Lights, class Materials, class Medium, class Random>
Color direct_light(AnyRay ray, const World& world, const Lights& lights,
                   const Place<Materials, Medium>& place, bool goes_on, Random& random) {
    return rt::todo("08.4", ray, world, lights, place, goes_on, random);
}

// Exercise 08.4. The light that comes back along a ray: your loop of 04.7, in a scene that may have
// lights and fog. Four things change.
//   - next_place(ray, world, materials, fog, random) takes the place of world.hit, and
//     place.scatter(random) that of materials(...); place.point, place.origin(direction) and
//     place.is_sky() do for surfaces and for fog.
//   - A second color holds the light that was collected so far. Every way out of the loop returns
//     it, plus what that way brings.
//   - A path that meets a light, place.light(lights), ends there and brings its radiance. It counts
//     shared_weight(drawn, lights.density(that light, from)), where `drawn` is the density with
//     which the bounce before drew its direction, and `from` the place of that bounce. It counts in
//     full where no light was looked for there: before the first bounce, and where drawn is 0.
//   - At each bounce, unless lights.empty(): where place.density(the bounce's direction) is greater
//     than 0, direct_light is added, times the throughput after this bounce's attenuation and
//     before the ending changes it. It `goes_on` unless the path ends in the sky.
// The order counts, as random numbers are drawn: next_place, scatter, the ending (if it is asked),
// direct_light. Without lights and fog the result is that of path_radiance, to the last bit.
template <class AnyRay, class World, class Materials, class Sky, class Lights, class Medium,
          class Ending, class Random>
Color lit_path_radiance(AnyRay ray, const World& world, const Materials& materials, const Sky& sky,
                        const Lights& lights, const Medium& fog, const Ending& ending, int depth,
                        Random& random) {
    return rt::todo("08.4", ray, world, materials, sky, lights, fog, ending, depth, random);
}

}  // namespace rt
