#include <answer.hpp>
#include <rt/ending.hpp>
#include <rt/path.hpp>

#include "types.hpp"

namespace answer EXPORTED {

rt::Color path_radiance(const rt::Ray& ray, const World<rt::Ray>& world, const Materials& materials,
                        const Sky& sky, const Ending& ending, int depth, rt::Rng& random) {
    return rt::path_radiance(ray, world, materials, sky, ending, depth, random);
}

rt::Color path_radiance(const TimedRay& ray, const World<TimedRay>& world,
                        const Materials& materials, const Sky& sky, const Ending& ending, int depth,
                        rt::Rng& random) {
    return rt::path_radiance(ray, world, materials, sky, ending, depth, random);
}

rt::PathEnd play_roulette(rt::Color& throughput, rt::Real most_likely, rt::Rng& random) {
    return rt::play_roulette(throughput, most_likely, random);
}

rt::PathEnd play_roulette(rt::Color& throughput, rt::Real most_likely,
                          checkpoint::AnyRandom& random) {
    return rt::play_roulette(throughput, most_likely, random);
}

rt::Real most_likely() {
    return rt::RouletteEnding{}.most_likely;
}

rt::PathEnd roulette_ending(rt::Real most_likely, rt::Color& throughput, rt::Rng& random) {
    return rt::RouletteEnding{most_likely}(throughput, random);
}

}  // namespace EXPORTED
