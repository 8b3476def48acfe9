#pragma once
#include <cstdint>
#include <rt/fixed_point.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 11.4. The 32 bits of x in reverse order: 0x00000001 becomes 0x80000000, and 0x80000000
// becomes 1.
inline std::uint32_t reversed_bits(std::uint32_t x) {
    return rt::todo("11.4", x);
}

// Point `index` of Sobol's sequence in two dimensions, point 0 being (0, 0). x has the bits of the
// index in reverse order. y is the exclusive or of one column for each bit of the index that is 1.
// Column 0, which belongs to the lowest bit, is 0x80000000, and each later column is c ^ c >> 1,
// where c is the column before it.
// Star: every 32-bit index must work. Five masked steps do the work of all columns at once.
// Source: Sobol', "On the distribution of points in a cube and the approximate evaluation of
// integrals", 1967.
inline FixedPoint2 sobol_point(std::uint32_t index) {
    return rt::todo("11.4", index);
}

// Owen's scrambling, a shuffling of all 32-bit fractions: bits are flipped as if at random. Whether
// a bit is flipped depends on the seed and on all higher bits, and on no lower bit. The text has
// five steps that do it, with the bits reversed.
// Star: the first seven flips are as random as coins, and the later ones nearly so. All 32 bits of
// the seed count: seed + 1 gives a different scrambling.
// Sources: Owen, "Randomly permuted (t,m,s)-nets and (t,s)-sequences", 1995; as a hash: Laine and
// Karras, "Stratified sampling for stochastic transparency", EGSR 2011; the two factors: Vegdahl,
// "Building a better LK hash", 2021.
inline std::uint32_t owen_scrambled(std::uint32_t fraction, std::uint32_t seed) {
    return rt::todo("11.4", fraction, seed);
}

}  // namespace rt
