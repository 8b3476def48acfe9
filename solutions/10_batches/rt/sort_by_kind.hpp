#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <rt/filter_list.hpp>
#include <rt/path_list.hpp>

namespace rt {

// Sorts the paths of a list by kind. masks[i] has one bit set: bit k if list[i] is of kind k, of
// `count` kinds (1 to 8). The paths of kind k are written to `to`, in the same order as in the
// list, from index result[k] to result[k + 1] - 1. `to` has room for twice as many paths as the
// list has. The function goes through the list once for each kind, eight paths at a time. A
// counting sort goes through it only twice, but takes longer: each path must wait until the path
// before it has been counted.
template <std::size_t count>
std::array<std::size_t, count + 1> sort_by_kind(PathList list, const std::uint8_t* masks,
                                                std::uint32_t* to) {
    std::array<std::size_t, count + 1> first{};
    for (unsigned kind = 0; kind < count; ++kind)
        first[kind + 1] = first[kind] + filter_list(list, masks, kind, to + first[kind]);
    return first;
}

}  // namespace rt
