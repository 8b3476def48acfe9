#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <rt/vector_registers.hpp>

namespace rt {

// For each number of eight bits: the indices of the bits that are set, in order.
inline constexpr auto marked_places = [] {
    std::array<std::array<std::uint8_t, 8>, 256> table{};
    for (std::size_t bits = 0; bits < table.size(); ++bits)
        for (std::uint8_t place = 0, count = 0; place < 8; ++place)
            if (bits >> place & 1) table[bits][count++] = place;
    return table;
}();

// Copies those of eight numbers whose masks have this bit to `to`, in order, and returns how many
// were copied (given). `to` must have room for eight numbers. If the processor can reorder eight
// numbers with one instruction, their masks are not tested one by one.
inline std::size_t copy_marked(const std::uint32_t* numbers, const std::uint8_t* masks,
                               unsigned bit, std::uint32_t* to) {
#ifdef RT_HAS_EIGHT_ORDERED
    const unsigned bits = RT_TOP_BITS_OF_EIGHT(masks, 7 - bit);
    RT_STORE_EIGHT_ORDERED(to, numbers, marked_places[bits].data());
    return static_cast<std::size_t>(std::popcount(bits));
#else
    std::size_t count = 0;
    for (std::size_t i = 0; i < 8; ++i) {
        to[count] = numbers[i];
        count += masks[i] >> bit & 1;
    }
    return count;
#endif
}

}  // namespace rt
