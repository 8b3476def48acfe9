#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace answer {

template <std::size_t count>
std::array<std::size_t, count + 1> sort_by_kind(std::span<const std::uint8_t> kinds,
                                                std::span<std::uint32_t> sorted);

}  // namespace answer

namespace rt {

using answer::sort_by_kind;

}  // namespace rt
