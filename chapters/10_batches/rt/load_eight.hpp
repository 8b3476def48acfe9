#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <rt/pack.hpp>
#include <utility>

namespace rt {

// Packs that fill a register of this processor (given), and functions that load them from records
// in memory and store them there.
inline constexpr std::size_t pack_size = RT_REGISTER_BYTES / sizeof(Real);
using Pack = PackOf<Real, pack_size>;
using PackMask = Bits<Pack>;  // -1 for true, 0 for false
using PackInteger = NumberOf<PackMask>;

// A pack with x in all lanes. (The compiler can leave out the subtraction, because x - 0 is x, even
// if x is -0.)
inline Pack pack_of(Real x) {
    return x - Pack{};
}

// Bit i belongs to lane i.
using PackBits = std::uint32_t;
inline PackBits bits_of(PackMask mask) {
    return RT_VECTOR_BITS(mask);
}
// The bits of the first `count` lanes of a pack.
constexpr PackBits first_bits(std::size_t count) {
    return (PackBits{1} << count) - 1;
}
// Calls visit(i) for each bit i that is set.
template <class Visit>
void for_each_bit(PackBits bits, Visit visit) {
    for (; bits; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

// A block: the numbers that the processor loads from a record at once. A pack holds one block or
// more.
using Block = PackOf<Real, 16 / sizeof(Real)>;
inline constexpr std::size_t block_size = sizeof(Block) / sizeof(Real);
inline constexpr std::size_t blocks = pack_size / block_size;

// The numbers of a and b with these indices; those of b follow those of a.
template <std::size_t... i, class Numbers>
RT_INLINED auto chosen(Numbers a, Numbers b) {
#if __has_builtin(__builtin_shufflevector)
    return __builtin_shufflevector(a, b, i...);
#else  // g++ 11
    constexpr std::size_t count = sizeof(Numbers) / sizeof(Real);
    return PackOf<Real, sizeof...(i)>{(i < count ? a[i] : b[i - count])...};
#endif
}

template <class Half, std::size_t... i>
auto join(Half low, Half high, std::index_sequence<i...>) {
    return chosen<i...>(low, high);
}
// Joins `count` blocks into one vector: block(first), block(first + 1) ...
template <std::size_t count = blocks, class GetBlock>
auto join_blocks(const GetBlock& block, std::size_t first = 0) {
    if constexpr (count == 1)
        return block(first);
    else
        return join(join_blocks<count / 2>(block, first),
                    join_blocks<count / 2>(block, first + count / 2),
                    std::make_index_sequence<count * block_size>{});
}
template <std::size_t number>
Block get_block(Pack pack) {
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
        return chosen<(number * block_size + i)...>(pack, pack);
    }
    (std::make_index_sequence<block_size>{});
}

// Takes numbers in turns from a and b: the first of a, the first of b, the second of a ... from the
// lower half of each block, or from the upper half if `half` is 1.
template <std::size_t half, std::size_t... i>
Pack interleave(Pack a, Pack b, std::index_sequence<i...>) {
    constexpr std::size_t n = block_size;
    return chosen<(i / n * n + half * n / 2 + i % n / 2 + (i % 2 ? pack_size : 0))...>(a, b);
}

// Swaps rows[i][k] and rows[k][i] within each block.
inline void transpose_blocks(Pack (&rows)[block_size]) {
    constexpr auto all = std::make_index_sequence<pack_size>{};
    constexpr std::size_t half = block_size / 2;
    for (std::size_t done = 1; done < block_size; done *= 2) {
        Pack shuffled[block_size];
        for (std::size_t i = 0; i < half; ++i) {
            shuffled[2 * i] = interleave<0>(rows[i], rows[i + half], all);
            shuffled[2 * i + 1] = interleave<1>(rows[i], rows[i + half], all);
        }
        for (std::size_t i = 0; i < block_size; ++i) rows[i] = shuffled[i];
    }
}

// Loads eight numbers from each of pack_size records, as eight packs: the first numbers of all
// records, the second numbers, and so on. record(i) is the address of record i.
template <class Record>
RT_INLINED std::array<Pack, 8> load_eight(const Record& record) {
    std::array<Pack, 8> packs;
    for (std::size_t first = 0; first < packs.size(); first += block_size) {
        Pack rows[block_size];
        for (std::size_t i = 0; i < block_size; ++i)
            rows[i] = join_blocks([&](std::size_t b) {
                const void* const numbers = record(b * block_size + i);
                return load<Block>(static_cast<const Real*>(numbers) + first);
            });
        transpose_blocks(rows);
        for (std::size_t k = 0; k < block_size; ++k) packs[first + k] = rows[k];
    }
    return packs;
}

// The inverse of load_eight: writes `count` numbers, a multiple of block_size, to each of pack_size
// records.
template <std::size_t count, class Record>
RT_INLINED void store(const std::array<Pack, count>& packs, const Record& record) {
    for (std::size_t first = 0; first < count; first += block_size) {
        Pack rows[block_size];
        for (std::size_t k = 0; k < block_size; ++k) rows[k] = packs[first + k];
        transpose_blocks(rows);
        for (std::size_t i = 0; i < block_size; ++i)
            [&]<std::size_t... b>(std::index_sequence<b...>) {
                const auto write = [&](std::size_t n, Block block) {
                    void* const numbers = record(n);
                    store(block, static_cast<Real*>(numbers) + first);
                };
                (write(b * block_size + i, get_block<b>(rows[i])), ...);
            }
        (std::make_index_sequence<blocks>{});
    }
}

}  // namespace rt
