#pragma once
#include <cstdint>
#include <limits>
#include <rt/real.hpp>

namespace rt {

// Mixes the bits of a counter so that neighboring counters give unrelated numbers.
// Source: SplitMix64, Steele, Lea and Flood, "Fast splittable pseudorandom number generators",
// OOPSLA 2014.
constexpr std::uint64_t mix_bits(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// A small, fast generator of random numbers: PCG-XSH-RR with 64 bits of state and 2^63 streams.
// It satisfies std::uniform_random_bit_generator.
// Source: O'Neill, "PCG: a family of simple fast space-efficient statistically good algorithms for
// random number generation", HMC-CS-2014-0905.
class Rng {
  public:
    using result_type = std::uint32_t;
    static constexpr result_type min() { return 0; }
    static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

    // Takes a state and a stream number, as PCG's reference code does, so that the check values of
    // PCG's author apply.
    constexpr Rng(std::uint64_t state, std::uint64_t stream) : increment_{stream << 1 | 1} {
        (*this)();
        state_ += state;
        (*this)();
    }

    // 32 random bits.
    constexpr result_type operator()() {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005u + increment_;
        const auto bits = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
        const auto turn = static_cast<std::uint32_t>(old >> 59);
        return bits >> turn | bits << (-turn & 31);
    }

    // A random number in [0, 1): every multiple of epsilon/2 is equally likely,
    // and 1 is never returned.
    constexpr Real uniform() {
        constexpr int digits = std::numeric_limits<Real>::digits;  // 24 in float, 53 in double
        if constexpr (digits <= 32) {
            return static_cast<Real>((*this)() >> (32 - digits)) * (epsilon / 2);
        } else {
            const std::uint64_t high = (*this)();
            return static_cast<Real>((high << 32 | (*this)()) >> (64 - digits)) * (epsilon / 2);
        }
    }

    // A random number in [low, high). Rounding can make it equal to high, for example in [1, 2).
    constexpr Real uniform(Real low, Real high) { return low + (high - low) * uniform(); }

  private:
    std::uint64_t state_ = 0;
    std::uint64_t increment_;
};

// A number for each pixel and seed: those of different pixels have nothing in common, and two
// pixels of a picture never have the same.
constexpr std::uint64_t pixel_state(std::uint64_t seed, int x, int y) {
    const auto pixel =
        std::uint64_t{static_cast<std::uint32_t>(y)} << 32 | static_cast<std::uint32_t>(x);
    return mix_bits(mix_bits(seed) ^ pixel);
}

// The generator of one pixel. Its numbers depend on the seed and the pixel alone, never on which
// thread asks for them or in what order. Different seeds and pixels give independent streams.
constexpr Rng pixel_rng(std::uint64_t seed, int x, int y) {
    const std::uint64_t state = pixel_state(seed, x, y);
    return {state, mix_bits(state)};
}

}  // namespace rt
