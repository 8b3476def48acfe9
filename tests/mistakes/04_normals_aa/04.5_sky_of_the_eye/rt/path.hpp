#pragma once
#include <optional>
#include <rt/color.hpp>
#include <rt/ending.hpp>
#include <rt/hit.hpp>
#include <rt/interval.hpp>
#include <rt/leave_surface.hpp>
#include <rt/scatter.hpp>

namespace rt {

template <class AnyRay, class World, class Materials, class Sky, class Ending, class Random>
Color path_radiance(AnyRay ray, const World& world, const Materials& materials, const Sky& sky,
                    const Ending& ending, int depth, Random& random) {
    const Vec3 eye = ray.direction;
    Color throughput{1, 1, 1};
    for (int bounces = 1;; ++bounces) {
        const std::optional<Hit> hit = world.hit(ray, Interval{0, infinity});
        if (!hit) return throughput * sky(eye);

        const std::optional<Scatter> bounce = materials(ray.direction, *hit, random);
        if (!bounce) return {};
        throughput *= bounce->attenuation;
        ray.origin = leave_surface(*hit, bounce->direction);
        ray.direction = bounce->direction;

        if (bounces < depth) continue;
        const Fate fate = ending(throughput, random);
        if (fate == Fate::ends_in_sky) return throughput * sky(ray.direction);
        if (fate == Fate::ends_in_black) return {};
    }
}

}  // namespace rt
