#pragma once
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

// A pack: `count` numbers of one type side by side in a register of the processor (given). One
// instruction does the same to all of them (SIMD: single instruction, multiple data). a + b adds
// each number of a to its partner in b, and each sum is rounded like that of two single numbers. A
// comparison gives a mask, -1 for true and 0 for false, and mask ? a : b takes each number from a
// where the mask is true, and from b elsewhere.
template <class T, std::size_t count>
struct PackType {
    typedef T Type RT_VECTOR_OF(count * sizeof(T));
};
template <class T, std::size_t count>
using PackOf = typename PackType<T, count>::Type;

// A pack of any type and size.
template <class T>
concept AnyPack =
    !std::is_class_v<T> && !std::is_array_v<T> && !std::is_pointer_v<T> && requires(T pack) {
    pack[0];
};
template <AnyPack Pack>
using NumberOf = std::remove_cvref_t<decltype(Pack{}[0])>;
template <AnyPack Pack>
inline constexpr std::size_t size_of = sizeof(Pack) / sizeof(NumberOf<Pack>);

// Reads a pack of numbers, beginning at this address.
template <AnyPack Pack>
RT_INLINED Pack load(const NumberOf<Pack>* numbers) {
    Pack pack;
    std::memcpy(&pack, numbers, sizeof pack);
    return pack;
}
template <AnyPack Pack>
RT_INLINED void store(const Pack& pack, NumberOf<Pack>* numbers) {
    std::memcpy(numbers, &pack, sizeof pack);
}

// Functions of the standard library, applied to each number of a pack: they give the same bits.
template <AnyPack Pack>
RT_INLINED Pack sqrt(Pack x) {
    for (std::size_t i = 0; i < size_of<Pack>; ++i) x[i] = std::sqrt(x[i]);
    return x;
}
template <AnyPack Pack>
RT_INLINED Pack fma(Pack a, Pack b, Pack c) {
    for (std::size_t i = 0; i < size_of<Pack>; ++i) c[i] = std::fma(a[i], b[i], c[i]);
    return c;
}
template <AnyPack Pack>
RT_INLINED Pack max(Pack a, Pack b) {
    return a < b ? b : a;
}
template <AnyPack Pack>
RT_INLINED Pack min(Pack a, Pack b) {
    return b < a ? b : a;
}

// The same for single numbers, so that one formula can take either. The result is `a` if `b` is
// NaN.
constexpr Real max(Real a, Real b) {
    return a < b ? b : a;
}
constexpr Real min(Real a, Real b) {
    return b < a ? b : a;
}

// A pack's bits, as integers of the same size as its numbers; sign_bit is the sign's bit in each.
template <AnyPack Pack>
using Bits = PackOf<std::conditional_t<sizeof(NumberOf<Pack>) == 4, std::int32_t, std::int64_t>,
                    size_of<Pack>>;
template <AnyPack Pack>
inline constexpr auto sign_bit = std::numeric_limits<NumberOf<Bits<Pack>>>::min();
template <AnyPack Pack>
RT_INLINED Pack abs(Pack x) {
    return std::bit_cast<Pack>(std::bit_cast<Bits<Pack>>(x) & ~(Bits<Pack>{} + sign_bit<Pack>));
}
template <AnyPack Pack>
RT_INLINED Pack copysign(Pack size, Pack sign) {
    const Bits<Pack> bit = Bits<Pack>{} + sign_bit<Pack>;
    return std::bit_cast<Pack>((std::bit_cast<Bits<Pack>>(size) & ~bit) |
                               (std::bit_cast<Bits<Pack>>(sign) & bit));
}

}  // namespace rt
