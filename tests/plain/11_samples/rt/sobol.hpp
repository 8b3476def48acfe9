#pragma once
#include <cstdint>
#include <rt/fixed_point.hpp>

namespace rt {
inline std::uint32_t reversed_bits(std::uint32_t x) {
    std::uint32_t result = 0;
    for (int i = 0; i < 32; ++i) {
        result = result << 1 | (x & 1);
        x >>= 1;
    }
    return result;
}

inline FixedPoint2 sobol_point(std::uint32_t index) {
    FixedPoint2 point{reversed_bits(index), 0};
    std::uint32_t column = 0x80000000u;
    for (std::uint32_t bits = index; bits != 0; bits >>= 1) {
        if (bits & 1) point.y ^= column;
        column ^= column >> 1;
    }
    return point;
}

inline std::uint32_t owen_scrambled(std::uint32_t fraction, std::uint32_t seed) {
    std::uint32_t x = reversed_bits(fraction);
    x ^= x * 0x3d20adeau;
    x += seed;
    x ^= x * (seed >> 16 & ~1u);
    x ^= seed >> 8;
    x ^= x * 0x53a22864u;
    return reversed_bits(x);
}
}  // namespace rt
