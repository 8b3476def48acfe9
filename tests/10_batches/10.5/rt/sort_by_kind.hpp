#pragma once
#include <array>
#include <cstddef>
#include <rt/path_list.hpp>

namespace answer {

template <std::size_t count>
std::array<std::size_t, count + 1> sort_by_kind(rt::PathList list, const std::uint8_t* masks,
                                                std::uint32_t* to);

}  // namespace answer

namespace rt {

using answer::sort_by_kind;

}  // namespace rt
