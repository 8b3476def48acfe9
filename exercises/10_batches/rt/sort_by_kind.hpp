#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <rt/todo.hpp>
#include <span>

namespace rt {

// Exercise 10.5. Sorts the numbers 0, 1, 2 ... by kinds[i], each less than `count` (which is 1
// to 256): those of kind k come to stand in `sorted` from the result's [k] on, before its [k + 1],
// in the order of their numbers. A kind without a number has an empty part: [k] and [k + 1] are the
// same. The last of the result, [count], is the length of the list. The time grows as the list
// does: count, add up, put each in its place. `sorted` is as long as `kinds`, which may be empty,
// or hold more than a hundred thousand.
template <std::size_t count>
std::array<std::size_t, count + 1> sort_by_kind(std::span<const std::uint8_t> kinds,
                                                std::span<std::uint32_t> sorted) {
    return rt::todo("10.5", kinds, sorted);
}

}  // namespace rt
