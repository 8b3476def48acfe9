#pragma once
#include <cstdint>
#include <rt/color_sum.hpp>
#include <rt/rng.hpp>

namespace rt {

// The generator of one sample of one pixel. It draws numbers that depend on these four arguments
// alone, never on which thread asks, when, or in which order. If any argument differs, the result
// is another generator, whose draws are unrelated to this one's. x, y and sample are 0 or more.
inline Rng sample_rng(std::uint64_t seed, int x, int y, int sample) {
    const std::uint64_t state =
        mix_bits(pixel_state(seed, x, y) ^ static_cast<std::uint64_t>(sample));
    return {state, mix_bits(state)};
}

// The average of draw(sample, random) over sample = 0 ... samples - 1, each with its own generator.
// There is 1 sample or more. draw returns a Color and takes its random numbers from `random`, an
// Rng&.
template <class Draw>
Color average_samples(std::uint64_t seed, int x, int y, int samples, const Draw& draw) {
    ColorSum sum;
    for (int sample = 0; sample < samples; ++sample) {
        Rng random = sample_rng(seed, x, y, sample);
        sum.add(draw(sample, random));
    }
    return sum.mean(samples);
}

}  // namespace rt
