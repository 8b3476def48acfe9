#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <rt/filter_list.hpp>
#include <rt/path_list.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 10.5. Sorts the paths of a list by kind. masks[i] has one bit set: bit k if list[i] is
// of kind k. There are `count` kinds, 1 to 8. The paths of kind k are written to `to`, in the same
// order as in the list, from index result[k] to result[k + 1] - 1. If there is none, result[k + 1]
// equals result[k]. result[count] is the length of the list. `to` has room for twice as many paths
// as the list has, so filter_list always has its room.
// Star: the list may be empty, or hold more than a hundred thousand paths.
template <std::size_t count>
std::array<std::size_t, count + 1> sort_by_kind(PathList list, const std::uint8_t* masks,
                                                std::uint32_t* to) {
    return rt::todo("10.5", list, masks, to);
}

}  // namespace rt
