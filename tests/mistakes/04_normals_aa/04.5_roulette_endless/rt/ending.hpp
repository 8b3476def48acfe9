#pragma once
#include <algorithm>
#include <rt/color.hpp>

namespace rt {

enum class Fate { ends_in_sky, ends_in_black, goes_on };

struct SkyEnding {
    template <class Random>
    Fate operator()(Color&, Random&) const {
        return Fate::ends_in_sky;
    }
};

struct BlackEnding {
    template <class Random>
    Fate operator()(Color&, Random&) const {
        return Fate::ends_in_black;
    }
};
template <class Random>
Fate play_roulette(Color& throughput, Real /*most_likely*/, Random& random) {
    const Real p = std::max({throughput.r, throughput.g, throughput.b});
    if (!(random.uniform() < p)) return Fate::ends_in_black;
    throughput /= p;
    return Fate::goes_on;
}

struct RouletteEnding {
    Real most_likely = Real(0.95);

    template <class Random>
    Fate operator()(Color& throughput, Random& random) const {
        return play_roulette(throughput, most_likely, random);
    }
};

}  // namespace rt
