#pragma once
#include <cstdint>
#include <span>

namespace rt {

// A list of paths, as indices in their batch.
using PathList = std::span<const std::uint32_t>;

// The memory in which descend() writes: room for a list and its masks at each level of the tree. No
// list is longer than the first list.
struct Scratch {
    std::uint32_t* lists;
    std::uint8_t* masks;
};

}  // namespace rt
