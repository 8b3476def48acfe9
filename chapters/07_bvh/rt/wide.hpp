#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <rt/pack.hpp>

namespace rt {

// Eight numbers side by side (given).
inline constexpr std::size_t lanes = 8;
template <class T>
using Lanes = std::array<T, lanes>;

// A part: as many of eight numbers as fit in one register.
template <class T>
inline constexpr std::size_t part_size = std::min(lanes, RT_REGISTER_BYTES / sizeof(T));
template <class T>
using Part = PackOf<T, part_size<T>>;
using Reals = Part<Real>;

}  // namespace rt
