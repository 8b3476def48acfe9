#pragma once
#include <cstddef>
#include <rt/path_list.hpp>

namespace answer {

std::size_t filter_list(rt::PathList list, const std::uint8_t* masks, unsigned bit,
                        std::uint32_t* to);

}  // namespace answer

namespace rt {

using answer::filter_list;

}  // namespace rt
