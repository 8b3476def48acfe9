#pragma once
#include <algorithm>
#include <rt/color.hpp>
#include <rt/path_end.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 04.7. Russian roulette: the path goes on with a probability p, and its throughput is
// divided by p, so that the paths that go on stand in for those that ended. This is correct on
// average: p * (1 / p) = 1. p is the largest component of the throughput, however small, but at
// most most_likely. Draw at most one random number. A black path, p = 0, ends even if 0 is drawn.
// Star: the probability is p to the last digits.
template <class Random>
PathEnd play_roulette(Color& throughput, Real most_likely, Random& random) {
    return rt::todo("04.7", throughput, most_likely, random);
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
