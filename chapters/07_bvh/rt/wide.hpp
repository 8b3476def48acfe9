#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <rt/real.hpp>
#include <rt/vector_registers.hpp>
#include <type_traits>

namespace rt {

// Eight numbers side by side (given).
inline constexpr std::size_t lanes = 8;
template <class T>
using Lanes = std::array<T, lanes>;

// A part: as many of eight numbers as fit in one register of the processor. One instruction
// does the same to all of them (SIMD: single instruction, multiple data). a + b adds each
// number of a to its partner in b, and rounds it as it would alone. A comparison gives a mask,
// -1 for true and 0 for false, and mask ? a : b takes each number from a where the mask is
// true, and from b elsewhere.
template <class T>
inline constexpr std::size_t part_size = std::min(lanes, RT_REGISTER_BYTES / sizeof(T));
template <class T>
struct PartOf {
    typedef T Type RT_VECTOR_OF(part_size<T> * sizeof(T));
};
template <class T>
using Part = typename PartOf<T>::Type;

// The numbers from index `first` on.
template <class T>
RT_INLINED Part<T> load_part(const Lanes<T>& numbers, std::size_t first) {
    Part<T> part;
    std::memcpy(&part, &numbers[first], sizeof part);
    return part;
}
template <class T>
RT_INLINED void store_part(const Part<T>& part, Lanes<T>& numbers, std::size_t first) {
    std::memcpy(&numbers[first], &part, sizeof part);
}

// Functions of the standard library, applied to each number of a part.
using Reals = Part<Real>;
RT_INLINED Reals part_sqrt(Reals x) {
    for (std::size_t i = 0; i < part_size<Real>; ++i) x[i] = std::sqrt(x[i]);
    return x;
}
RT_INLINED Reals part_copysign(Reals size, Reals sign) {
    using Integer = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;
    const Part<Integer> bit = Part<Integer>{} + std::numeric_limits<Integer>::min();
    return std::bit_cast<Reals>((std::bit_cast<Part<Integer>>(size) & ~bit) |
                                (std::bit_cast<Part<Integer>>(sign) & bit));
}

}  // namespace rt
