#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace rt {

// Sorts the numbers i = 0, 1, 2 ... by their kinds, kinds[i], each of which is less than `count`.
// The numbers of kind k are written in ascending order to `sorted`, from index result[k] to
// result[k + 1] - 1. The function takes linear time: it counts first, and then puts each number in
// its place. `sorted` is as long as `kinds`.
template <std::size_t count>
std::array<std::size_t, count + 1> sort_by_kind(std::span<const std::uint8_t> kinds,
                                                std::span<std::uint32_t> sorted) {
    std::array<std::size_t, count + 1> first{};
    for (const std::uint8_t kind : kinds) ++first[kind + std::size_t{1}];
    for (std::size_t kind = 0; kind < count; ++kind) first[kind + 1] += first[kind];
    auto next = first;
    for (std::size_t i = 0; i < kinds.size(); ++i)
        sorted[next[kinds[i]]++] = static_cast<std::uint32_t>(i);
    return first;
}

}  // namespace rt
