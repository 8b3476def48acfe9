#pragma once
#include <cstdint>
#include <rt/todo.hpp>
#include <rt/vec2.hpp>

namespace rt {

// Exercise 11.4. The same 32 bits, the last one first.
inline std::uint32_t reversed_bits(std::uint32_t x) {
    return rt::todo("11.4", x);
}

// A point of the unit square; both are 32 bits after the point, so 0x80000000 is one half.
struct FixedPoint2 {
    std::uint32_t x = 0, y = 0;

    friend constexpr bool operator==(const FixedPoint2&, const FixedPoint2&) = default;
};

// Point `index` of Sobol's sequence in two dimensions. Of the points k * 2^m ... (k + 1) * 2^m - 1
// there is exactly one in each of the 2^m boxes of equal size into which the square can be halved
// again and again. Source: Sobol', "On the distribution of points in a cube and the approximate
// evaluation of integrals", 1967; its matrices for the first two dimensions are the mirrored unit
// matrix and Pascal's triangle modulo 2.
inline FixedPoint2 sobol_point(std::uint32_t index) {
    return rt::todo("11.4", index);
}

// Shuffles all 32-bit fractions, by Owen's scrambling: a random bit decides whether the two halves
// of the interval change places, two more decide it for the halves of each half, and so on.
// Fractions that share their first n bits share them afterwards. Another seed gives another
// shuffling. Sources: Owen, "Randomly permuted (t,m,s)-nets and (t,s)-sequences", 1995; as a hash:
// Laine and Karras, "Stratified sampling for stochastic transparency", EGSR 2011; the constants:
// Burley, "Practical hash-based Owen scrambling", JCGT 2020.
inline std::uint32_t owen_scrambled(std::uint32_t fraction, std::uint32_t seed) {
    return rt::todo("11.4", fraction, seed);
}

}  // namespace rt
