#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <rt/todo.hpp>
#include <span>

namespace rt {

// Exercise 10.5. Sorts the numbers i = 0, 1, 2 ... by their kinds, kinds[i]. Every kind is less
// than `count`, which is 1 to 256. The numbers of kind k are written in ascending order to
// `sorted`, from index result[k] to result[k + 1] - 1. If there is no number of kind k, result[k]
// and result[k + 1] are the same. The last element, result[count], is the length of `kinds` and of
// `sorted`.
// Star: the time grows in proportion to the length of the list: count, add up, put each number in
// its place. The list may be empty, or hold more than a hundred thousand numbers.
template <std::size_t count>
std::array<std::size_t, count + 1> sort_by_kind(std::span<const std::uint8_t> kinds,
                                                std::span<std::uint32_t> sorted) {
    return rt::todo("10.5", kinds, sorted);
}

}  // namespace rt
