#pragma once
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <rt/compiler.hpp>
#include <rt/real.hpp>
#include <utility>

namespace rt {

// As many numbers as one register of this processor holds (given), for arithmetic on all of them at
// once: a + b adds each number of a to its partner in b, and rounds as one number alone would. A
// comparison gives a PackMask, and mask ? a : b takes from a where the mask is true, else from b.
inline constexpr std::size_t pack_size = RT_REGISTER_BYTES / sizeof(Real);
using PackInteger = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;
typedef Real Pack RT_VECTOR_OF(RT_REGISTER_BYTES);
typedef PackInteger PackMask RT_VECTOR_OF(RT_REGISTER_BYTES);  // -1 for true, 0 for false

// The same number, pack_size times.
inline Pack pack_of(Real x) {
    return Pack{} + x;
}

// Bit i is number i's.
using PackBits = std::uint32_t;
inline PackBits bits_of(PackMask mask) {
    return RT_VECTOR_BITS(mask);
}
// The bits of the first numbers of a pack.
constexpr PackBits first_bits(std::size_t count) {
    return (PackBits{1} << count) - 1;
}
// Calls visit(i) for each bit that is set.
template <class Visit>
void for_each_bit(PackBits bits, Visit visit) {
    for (; bits; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

// What the standard library has for one number, for all of a pack: the same bits.
inline Pack sqrt(Pack x) {
    for (std::size_t i = 0; i < pack_size; ++i) x[i] = std::sqrt(x[i]);
    return x;
}
inline Pack fma(Pack a, Pack b, Pack c) {
    for (std::size_t i = 0; i < pack_size; ++i) c[i] = std::fma(a[i], b[i], c[i]);
    return c;
}
inline Pack max(Pack a, Pack b) {
    return a < b ? b : a;
}
inline Pack min(Pack a, Pack b) {
    return b < a ? b : a;
}
inline constexpr PackInteger sign_bit = std::numeric_limits<PackInteger>::min();
inline Pack abs(Pack x) {
    return std::bit_cast<Pack>(std::bit_cast<PackMask>(x) & ~(PackMask{} + sign_bit));
}
inline Pack copysign(Pack size, Pack sign) {
    const PackMask bit = PackMask{} + sign_bit;
    return std::bit_cast<Pack>((std::bit_cast<PackMask>(size) & ~bit) |
                               (std::bit_cast<PackMask>(sign) & bit));
}

// The first of a, the first of b, the second of a, the second of b ... from their lower or upper
// halves.
template <std::size_t half, std::size_t... i>
Pack interleave(Pack a, Pack b, std::index_sequence<i...>) {
    return __builtin_shufflevector(a, b,
                                   (half * pack_size / 2 + i / 2 + (i % 2 ? pack_size : 0))...);
}

// rows[i][k] and rows[k][i] change places: so records of pack_size numbers become packs, each of
// one kind of number, and packs become records.
inline void transpose(Pack (&rows)[pack_size]) {
    constexpr auto all = std::make_index_sequence<pack_size>{};
    for (std::size_t done = 1; done < pack_size; done *= 2) {
        Pack shuffled[pack_size];
        for (std::size_t i = 0; i < pack_size / 2; ++i) {
            shuffled[2 * i] = interleave<0>(rows[i], rows[i + pack_size / 2], all);
            shuffled[2 * i + 1] = interleave<1>(rows[i], rows[i + pack_size / 2], all);
        }
        std::memcpy(rows, shuffled, sizeof rows);
    }
}

}  // namespace rt
