#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <rt/compiler.hpp>

namespace rt {

// For each way in which eight numbers may be marked, a bit each: the places of those that are, in
// their order.
inline constexpr auto marked_places = [] {
    std::array<std::array<std::uint8_t, 8>, 256> table{};
    for (std::size_t bits = 0; bits < table.size(); ++bits)
        for (std::uint8_t place = 0, count = 0; place < 8; ++place)
            if (bits >> place & 1) table[bits][count++] = place;
    return table;
}();

// Copies those of eight numbers whose mask has this bit to `to`, in their order, and returns how
// many they are (given). There must be room for eight. Where the processor can put eight numbers
// into any order by one instruction, nothing is asked one by one.
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
