#pragma once
#include <cstdint>
#include <rt/color.hpp>
#include <rt/rng.hpp>

namespace rt {

inline Rng sample_rng(std::uint64_t seed, int x, int y, int sample) {
    const std::uint64_t state = seed + static_cast<std::uint64_t>(x) +
                                static_cast<std::uint64_t>(y) + static_cast<std::uint64_t>(sample);
    return {state, 0};
}

template <class Draw>
Color average_samples(std::uint64_t seed, int x, int y, int samples, const Draw& draw) {
    Color sum;
    for (int sample = 0; sample < samples; ++sample) {
        Rng random = sample_rng(seed, x, y, sample);
        sum += draw(sample, random);
    }
    return sum / static_cast<Real>(samples);
}

}  // namespace rt
