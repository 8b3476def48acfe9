#pragma once
// Chains whose links are scattered in memory.

#include <rt/chain.hpp>
#include <rt/rng.hpp>
#include <vector>

namespace toolchain {

using namespace rt;

// A chain through all links of one array, in random order. It starts at the array's first link.
struct ScatteredChain {
    explicit ScatteredChain(std::size_t count) : links(count) {
        // Sattolo's way of shuffling makes a permutation that is one single cycle.
        std::vector<std::uint32_t> next(count);
        for (std::size_t i = 0; i < count; ++i) next[i] = static_cast<std::uint32_t>(i);
        Rng rng{7, 1};
        for (std::size_t i = count; i-- > 1;) std::swap(next[i], next[rng() % i]);
        for (std::size_t i = 0; i < count; ++i)
            links[i] = {1, next[i] == 0 ? nullptr : &links[next[i]]};
    }
    const Link* first() const { return links.data(); }

    std::vector<Link> links;
};

}  // namespace toolchain
