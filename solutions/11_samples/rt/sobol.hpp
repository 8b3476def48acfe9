#pragma once
#include <cstdint>
#include <rt/fixed_point.hpp>

namespace rt {

// The same 32 bits in reverse order: 0x00000001 becomes 0x80000000, and 0x80000000 becomes 1.
inline std::uint32_t reversed_bits(std::uint32_t x) {
    x = x >> 16 | x << 16;
    x = (x & 0xff00ff00u) >> 8 | (x & 0x00ff00ffu) << 8;
    x = (x & 0xf0f0f0f0u) >> 4 | (x & 0x0f0f0f0fu) << 4;
    x = (x & 0xccccccccu) >> 2 | (x & 0x33333333u) << 2;
    return (x & 0xaaaaaaaau) >> 1 | (x & 0x55555555u) << 1;
}

// Point `index` of Sobol's sequence in two dimensions, in the order of the formula itself (not that
// of a Gray code); point 0 is (0, 0). x has the bits of the index in reverse order. y is the
// exclusive or of one column for each bit of the index that is 1. Column 0, which belongs to the
// lowest bit, is 0x80000000, and each later column is c ^ c >> 1, where c is the column before it.
//
// Of the points k 2^m, k 2^m + 1 ... (k + 1) 2^m - 1, exactly one is in each of the 2^m boxes of
// equal size and shape into which repeated halving can cut the square. Source: Sobol', "On the
// distribution of points in a cube and the approximate evaluation of integrals", 1967; the columns
// are Pascal's triangle modulo 2.
inline FixedPoint2 sobol_point(std::uint32_t index) {
    const std::uint32_t x = reversed_bits(index);
    // Pascal's triangle modulo 2 is three copies of a triangle of half its height, and zeros. So
    // the 32 digits of y follow from the 16 digits that each half of x would give alone: the first
    // half of y is the exclusive or of both results, and the second half is the result for the
    // second half of x. The same holds for each half and its own halves, down to single digits:
    // five steps instead of up to 32 columns.
    std::uint32_t y = x;
    y ^= (y & 0x55555555u) << 1;
    y ^= (y & 0x33333333u) << 2;
    y ^= (y & 0x0f0f0f0fu) << 4;
    y ^= (y & 0x00ff00ffu) << 8;
    y ^= y << 16;
    return {x, y};
}

// Owen's scrambling, a shuffling of all 32-bit fractions. A random bit decides whether to swap the
// two halves of the interval, two more bits decide whether to swap the two halves of each half, and
// so on. Whether a bit of the fraction is flipped thus depends on the seed and on all higher bits,
// and on no lower bit. If two fractions agree in their first n bits and differ in the next bit, so
// do their results. Over all seeds, each of the 128 patterns of the seven flips of the first three
// bits occurs equally often. Each later flip happens half of the time, and any two agree about half
// of the time; 32 bits of a seed cannot make all flips independent. All bits of the seed count:
// seed + 1 gives a different scrambling. (One flip alone may change nearly every time the seed
// increases by 1, as the first flip does here.)
//
// Scrambling needs a hash, and any good one will do. The one here works on x, the fraction with its
// bits reversed. In x, the higher bits of the fraction are to the right, and a product or a sum
// carries only to the left. The steps in their order: x ^= x * 0x3d20adea, x += seed,
// x ^= x * (seed >> 16 & ~1), x ^= seed >> 8, x ^= x * 0x53a22864.
// Sources: Owen, "Randomly permuted (t,m,s)-nets and (t,s)-sequences", 1995; as a hash: Laine and
// Karras, "Stratified sampling for stochastic transparency", EGSR 2011; the two factors: Vegdahl,
// "Building a better LK hash", 2021.
inline std::uint32_t owen_scrambled(std::uint32_t fraction, std::uint32_t seed) {
    std::uint32_t x = reversed_bits(fraction);
    // The factors are even, so a bit of x is changed by lower bits only: if it also changed itself,
    // it could be lost. Three parts of the seed change the lowest bits, each in a different way.
    x ^= x * 0x3d20adeau;
    x += seed;
    x ^= x * (seed >> 16 & ~1u);
    x ^= seed >> 8;
    x ^= x * 0x53a22864u;
    return reversed_bits(x);
}

}  // namespace rt
