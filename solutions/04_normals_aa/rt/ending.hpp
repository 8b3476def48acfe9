#pragma once
#include <algorithm>
#include <rt/color.hpp>
#include <rt/fate.hpp>

namespace rt {

// Russian roulette: the path goes on with a probability p, and its throughput is divided by p, so
// that the paths that go on stand in for those that ended. Correct on average: p * (1 / p) = 1.
template <class Random>
Fate play_roulette(Color& throughput, Real most_likely, Random& random) {
    // Bright paths are worth following. A path with no light left never goes on.
    const Real p = std::min(most_likely, std::max({throughput.r, throughput.g, throughput.b}));
    if (!(random.uniform() < p)) return Fate::ends_in_black;
    throughput /= p;
    return Fate::goes_on;
}

struct RouletteEnding {
    // Below 1, so that even a path between white surfaces ends eventually.
    Real most_likely = Real(0.95);

    template <class Random>
    Fate operator()(Color& throughput, Random& random) const {
        return play_roulette(throughput, most_likely, random);
    }
};

}  // namespace rt
