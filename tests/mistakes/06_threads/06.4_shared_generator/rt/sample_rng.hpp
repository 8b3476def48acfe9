#pragma once
#include <cstdint>
#include <rt/color.hpp>
#include <rt/rng.hpp>

namespace rt {

inline Rng sample_rng(std::uint64_t seed, int x, int y, int sample) {
    const auto pixel = static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x);
    const std::uint64_t state =
        mix_bits(mix_bits(mix_bits(seed) ^ pixel) ^ static_cast<std::uint64_t>(sample));
    return {state, mix_bits(state)};
}

template <class Draw>
Color average_samples(std::uint64_t seed, int x, int y, int samples, const Draw& draw) {
    static Rng random = sample_rng(seed, x, y, 0);
    Color sum;
    for (int sample = 0; sample < samples; ++sample) {
        sum += draw(sample, random);
    }
    return sum / static_cast<Real>(samples);
}

}  // namespace rt
