#pragma once
#include <cstdint>
#include <span>

namespace rt {

// Numbers of paths in a batch.
using PathList = std::span<const std::uint32_t>;

// Room for what descend() writes: a list, and its masks, for each level of nodes on the way down.
// No list is longer than the first one.
struct Scratch {
    std::uint32_t* lists;
    std::uint8_t* masks;
};

}  // namespace rt
