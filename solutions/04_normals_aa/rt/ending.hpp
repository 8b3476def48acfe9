#pragma once
#include <algorithm>
#include <rt/color.hpp>
#include <rt/path_end.hpp>

namespace rt {

// Russian roulette: the path goes on with a probability p, and its throughput is divided by p, so
// that the paths that go on stand in for those that ended. On average, this is correct, because
// p * (1 / p) = 1.
template <class Random>
PathEnd play_roulette(Color& throughput, Real most_likely, Random& random) {
    // Bright paths are worth following. A path with no light left never goes on.
    const Real p = std::min(most_likely, std::max({throughput.r, throughput.g, throughput.b}));
    if (!(random.uniform() < p)) return PathEnd::in_black;
    throughput /= p;
    return PathEnd::none;
}

struct RouletteEnding {
    // Below 1, so that even a path between white surfaces ends eventually.
    Real most_likely = Real(0.95);

    template <class Random>
    PathEnd operator()(Color& throughput, Random& random) const {
        return play_roulette(throughput, most_likely, random);
    }
};

}  // namespace rt
