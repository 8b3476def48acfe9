#pragma once
#include <cstddef>
#include <cstdint>
#include <rt/path_list.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 10.1. Copies to `to` those paths of a list whose mask has bit number `bit` set (0 to 7),
// in the same order, and returns how many there are. masks[i] is the mask of list[i]; its other
// bits do not matter. `to` has room for as many paths as the list has, and does not overlap it.
// Star: a path is any 32-bit number; the list may be empty, or hold more than a hundred thousand
// paths. What `to` holds after the copies does not matter; nothing outside `to` may change.
inline std::size_t filter_list(PathList list, const std::uint8_t* masks, unsigned bit,
                               std::uint32_t* to) {
    return rt::todo("10.1", list, masks, bit, to);
}

}  // namespace rt
