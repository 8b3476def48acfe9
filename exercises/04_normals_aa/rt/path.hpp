#pragma once
#include <optional>
#include <rt/color.hpp>
#include <rt/ending.hpp>
#include <rt/hit.hpp>
#include <rt/interval.hpp>
#include <rt/leave_surface.hpp>
#include <rt/scatter.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 04.7. The light that comes back along a ray. Its path is followed from bounce to bounce
// until it meets the sky, is absorbed, or is ended by `ending`, which is called after bounce
// number `depth`, 1 or more, and after every later one. Every hit counts, at any t from 0 to
// infinity, and so does all light, however dim. leave_surface is the one from 04.6. The function
// is written over types:
//   ray        has an origin and a direction; whatever else it carries stays as it is
//   world      world.hit(ray, interval) gives the nearest hit as std::optional<Hit>
//   materials  materials(direction, hit, random) gives std::optional<Scatter>, none if absorbed
//   sky        sky(direction) gives the Color of the light from there
//   ending     ending(throughput, random) gives the PathEnd of a path that has made its bounces
//   random     random.uniform() gives a random number in [0, 1)
template <class AnyRay, class World, class Materials, class Sky, class Ending, class Random>
Color path_radiance(AnyRay ray, const World& world, const Materials& materials, const Sky& sky,
                    const Ending& ending, int depth, Random& random) {
    return rt::todo("04.7", ray, world, materials, sky, ending, depth, random);
}

}  // namespace rt
