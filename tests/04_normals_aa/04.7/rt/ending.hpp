#pragma once
#include "../types.hpp"

namespace answer {

rt::PathEnd play_roulette(rt::Color& throughput, rt::Real most_likely, rt::Rng& random);
rt::PathEnd play_roulette(rt::Color& throughput, rt::Real most_likely,
                          checkpoint::AnyRandom& random);
rt::Real most_likely();
rt::PathEnd roulette_ending(rt::Real most_likely, rt::Color& throughput, rt::Rng& random);

}  // namespace answer

namespace rt {

template <class Random>
PathEnd play_roulette(Color& throughput, Real most_likely, Random& random) {
    checkpoint::AnyRandom any{random};
    return answer::play_roulette(throughput, most_likely, any);
}
inline PathEnd play_roulette(Color& throughput, Real most_likely, Rng& random) {
    return answer::play_roulette(throughput, most_likely, random);
}

struct RouletteEnding {
    Real most_likely = answer::most_likely();
    PathEnd operator()(Color& throughput, Rng& random) const {
        return answer::roulette_ending(most_likely, throughput, random);
    }
};

}  // namespace rt
