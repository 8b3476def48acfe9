#pragma once
// Points that fill the unit square more evenly than random points: an Owen-scrambled Sobol
// sequence.

#include <cstdint>
#include <rt/rng.hpp>

namespace normals_aa {

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x & 0xff00ff00u) >> 8) | ((x & 0x00ff00ffu) << 8);
    x = ((x & 0xf0f0f0f0u) >> 4) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x & 0xccccccccu) >> 2) | ((x & 0x33333333u) << 2);
    return ((x & 0xaaaaaaaau) >> 1) | ((x & 0x55555555u) << 1);
}

// The first two dimensions of Sobol's sequence, as fractions of 2^32.
constexpr std::uint32_t sobol_x(std::uint32_t index) {
    return reverse_bits(index);
}
constexpr std::uint32_t sobol_y(std::uint32_t index) {
    std::uint32_t y = 0;
    for (std::uint32_t column = 1u << 31; index; index >>= 1, column ^= column >> 1)
        if (index & 1) y ^= column;
    return y;
}

// At random, swaps the two halves of [0, 1) or leaves them; then does the same within each half,
// and so on. Evenly spread numbers stay evenly spread. Source: Burley, "Practical hash-based Owen
// scrambling", JCGT 9(4), 2020.
constexpr std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed) {
    x = reverse_bits(x) + seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return reverse_bits(x);
}

// The numbers of one sample of one pixel. Each pair of them is a point of a sequence of its own,
// which has its own scrambling and its own order.
class LowDiscrepancy {
  public:
    LowDiscrepancy(std::uint64_t seed, int x, int y, int sample)
        : pixel_{rt::pixel_state(seed, x, y)}, sample_{static_cast<std::uint32_t>(sample)} {}

    rt::Real uniform() {
        if (dimension_ % 2 == 0) {
            const std::uint64_t hash = rt::mix_bits(pixel_ + dimension_);
            index_ = owen_scramble(sample_, static_cast<std::uint32_t>(hash));
            scramble_ = rt::mix_bits(hash);
        }
        const std::uint32_t bits =
            dimension_ % 2 == 0
                ? owen_scramble(sobol_x(index_), static_cast<std::uint32_t>(scramble_))
                : owen_scramble(sobol_y(index_), static_cast<std::uint32_t>(scramble_ >> 32));
        ++dimension_;
        // As many bits as Real has, so that the number is never rounded up to 1.
        constexpr int digits = std::numeric_limits<rt::Real>::digits;
        constexpr int spare = digits < 32 ? 32 - digits : 0;
        return static_cast<rt::Real>(bits >> spare) / static_cast<rt::Real>(1ull << (32 - spare));
    }

  private:
    std::uint64_t pixel_, scramble_ = 0;
    std::uint32_t sample_, index_ = 0, dimension_ = 0;
};

}  // namespace normals_aa
