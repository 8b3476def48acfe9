#pragma once
#include "../types.hpp"

namespace answer {

rt::Color path_radiance(const rt::Ray& ray, const World<rt::Ray>& world, const Materials& materials,
                        const Sky& sky, const Ending& ending, int depth, rt::Rng& random);
rt::Color path_radiance(const TimedRay& ray, const World<TimedRay>& world,
                        const Materials& materials, const Sky& sky, const Ending& ending, int depth,
                        rt::Rng& random);

}  // namespace answer

namespace rt {

template <class AnyRay, class World, class Materials, class Sky, class Ending>
Color path_radiance(const AnyRay& ray, const World& world, const Materials& materials,
                    const Sky& sky, const Ending& ending, int depth, Rng& random) {
    const answer::World<AnyRay> find{
        [&](const AnyRay& by, Interval within) { return world.hit(by, within); }};
    return answer::path_radiance(ray, find, std::ref(materials), std::ref(sky), std::ref(ending),
                                 depth, random);
}

}  // namespace rt
