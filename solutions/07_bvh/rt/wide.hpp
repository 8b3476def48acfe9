#pragma once
#include <array>
#include <cstddef>

namespace rt {

// Eight numbers side by side (given). A loop that does the same to all eight and has no branch
// becomes a few wide instructions (SIMD: single instruction, multiple data). "#pragma omp simd"
// before it asks for that, and promises that the eight do not depend on each other;
// reduction(min : x) says that x becomes the smallest of all. The arrays are given as pointers: g++
// 12 leaves some loops over arrays of a structure as they are.
inline constexpr std::size_t lanes = 8;
template <class T>
using Lanes = std::array<T, lanes>;

}  // namespace rt
