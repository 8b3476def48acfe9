#pragma once
#include <optional>
#include <rt/color.hpp>
#include <rt/ending.hpp>
#include <rt/hit.hpp>
#include <rt/interval.hpp>
#include <rt/leave_surface.hpp>
#include <rt/scatter.hpp>

namespace rt {

// The light that comes back along a ray. The path is followed from bounce to bounce until it meets
// the sky, is absorbed, or has bounced `depth` times (at least 1): then `ending` decides. The
// arguments may have any types that do the following:
//   ray        has an origin and a direction; whatever else it carries stays as it is
//   world      is a World: world.hit(ray, interval) gives the nearest hit
//   materials  materials(direction, hit, random) gives std::optional<Scatter>, none if absorbed
//   sky        sky(direction) gives the Color of the light from there
//   ending     is an Ending: ending(throughput, random) decides how a path of `depth` bounces ends
//   random     random.uniform() gives a random number in [0, 1)
template <class AnyRay, class World, class Materials, class Sky, class Ending, class Random>
Color path_radiance(AnyRay ray, const World& world, const Materials& materials, const Sky& sky,
                    const Ending& ending, int depth, Random& random) {
    Color throughput{1, 1, 1};
    for (int bounces = 1;; ++bounces) {
        const std::optional<Hit> hit = world.hit(ray, Interval{0, infinity});
        if (!hit) return throughput * sky(ray.direction);

        const std::optional<Scatter> bounce = materials(ray.direction, *hit, random);
        if (!bounce) return {};
        throughput *= bounce->attenuation;
        ray.origin = leave_surface(*hit, bounce->direction);
        ray.direction = bounce->direction;

        if (bounces < depth) continue;
        const PathEnd end = ending(throughput, random);
        if (end == PathEnd::in_sky) return throughput * sky(ray.direction);
        if (end == PathEnd::in_black) return {};
    }
}

}  // namespace rt
