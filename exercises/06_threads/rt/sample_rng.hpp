#pragma once
#include <cstdint>
#include <rt/color.hpp>
#include <rt/rng.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 06.4. The generator of one sample of one pixel. Its numbers depend on these four
// arguments alone, never on which thread asks, when, or in which order. If any argument differs,
// the result is a different generator, and the two draw unrelated numbers from the first draw on.
// x, y and sample are 0 or more, and the state has 64 bits.
// Star: every bit of the four arguments counts, however large they are.
inline Rng sample_rng(std::uint64_t seed, int x, int y, int sample) {
    return rt::todo("06.4", seed, x, y, sample);
}

// Exercise 06.4. The average of draw(sample, random) over sample = 0 ... samples - 1, in this
// order, each with its own generator. There is 1 sample or more. draw returns a Color and takes its
// random numbers from `random`, an Rng&. Plain sums are accurate enough: the average may be off by
// rounding_bound(4 samples + 8) times the largest color.
template <class Draw>
Color average_samples(std::uint64_t seed, int x, int y, int samples, const Draw& draw) {
    return rt::todo("06.4", seed, x, y, samples, draw);
}

}  // namespace rt
