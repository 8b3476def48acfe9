#pragma once
// The compiler-specific code for the processor's wide registers. Instructions have the names that
// g++ and clang++ give them, because <immintrin.h>, which has the official names, takes the
// compiler a quarter of a second to read.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <rt/compiler.hpp>
#include <type_traits>

// RT_VECTOR_OF: turns a type into a vector of this many bytes.
// RT_REGISTER_BYTES: the size of the widest register that this program is compiled for.
// RT_VECTOR_BITS, below: a mask, which is a vector whose lanes are -1 or 0, as an integer with one
// bit per lane.
#define RT_VECTOR_OF(bytes) __attribute__((vector_size(bytes)))
#if defined(__AVX512F__) && defined(__AVX512DQ__)
#define RT_REGISTER_BYTES 64
#elif defined(__AVX2__)
#define RT_REGISTER_BYTES 32
#else
#define RT_REGISTER_BYTES 16
#endif

// RT_FUSED: a * b + c for a vector a and numbers b and c. For eight floats it is rounded once
// if the processor has one instruction for that. Otherwise it is rounded twice, so use it only
// where no bit of a picture depends on it.
#ifdef __FMA__
template <class Vector, class Number>
RT_INLINED Vector rt_fused(Vector a, Number b, Number c) {
    // x - Vector{} is a vector with x in every lane: the compiler copies x into all lanes, and
    // subtracting 0 changes nothing.
    if constexpr (sizeof(Vector) == 32 && sizeof(Number) == sizeof(float))
        return __builtin_ia32_vfmaddps256(a, b - Vector{}, c - Vector{});
    else
        return a * b + c;
}
#define RT_FUSED(a, b, c) rt_fused(a, b, c)
#else
#define RT_FUSED(a, b, c) ((a) * (b) + (c))
#endif

template <class Mask>
inline unsigned rt_vector_bits(const Mask& mask) {
    constexpr std::size_t size = sizeof(Mask), count = size / sizeof(mask[0]);
    [[maybe_unused]] constexpr bool is_short = sizeof(mask[0]) == 4;
    // Each instruction takes the mask as a different vector type; the bits are the same.
#ifdef __AVX512DQ__
    if constexpr (size == 64) {
        typedef int Short RT_VECTOR_OF(64);
        typedef long long Long RT_VECTOR_OF(64);
        return is_short ? __builtin_ia32_cvtd2mask512((Short)mask)
                        : __builtin_ia32_cvtq2mask512((Long)mask);
    }
#endif
#ifdef __AVX2__
    if constexpr (size == 32) {
        typedef float Short RT_VECTOR_OF(32);
        typedef double Long RT_VECTOR_OF(32);
        return static_cast<unsigned>(is_short ? __builtin_ia32_movmskps256((Short)mask)
                                              : __builtin_ia32_movmskpd256((Long)mask));
    }
#endif
#ifdef __SSE2__
    if constexpr (size == 16) {
        typedef float Short RT_VECTOR_OF(16);
        typedef double Long RT_VECTOR_OF(16);
        return static_cast<unsigned>(is_short ? __builtin_ia32_movmskps((Short)mask)
                                              : __builtin_ia32_movmskpd((Long)mask));
    }
#endif
    if constexpr (size > 16 && size > RT_REGISTER_BYTES) {
        typedef std::remove_cvref_t<decltype(mask[0])> Half RT_VECTOR_OF(size / 2);
        Half halves[2];
        std::memcpy(halves, &mask, size);
        return rt_vector_bits(halves[0]) | rt_vector_bits(halves[1]) << count / 2;
    }
    unsigned bits = 0;
    for (std::size_t i = 0; i < count; ++i) bits |= mask[i] ? 1u << i : 0;
    return bits;
}
#define RT_VECTOR_BITS(mask) rt_vector_bits(mask)

// RT_TOP_BITS_OF_EIGHT: shifts eight bytes to the left by `shift` bits and returns the top bit of
// each byte.
// RT_STORE_EIGHT_ORDERED: puts eight 32-bit numbers in the order that `places` gives, with a single
// instruction, and stores them.
// Both macros exist only if the program is compiled for a processor with AVX2.
#ifdef __AVX2__
#define RT_HAS_EIGHT_ORDERED
typedef char rt_bytes RT_VECTOR_OF(16);
typedef long long rt_halves RT_VECTOR_OF(16);
// A register with these eight bytes, and eight more that are 0.
RT_INLINED rt_halves rt_eight_bytes(const std::uint8_t* from) {
    long long bytes;
    std::memcpy(&bytes, from, sizeof bytes);
    return rt_halves{bytes, 0};
}
RT_INLINED unsigned rt_top_bits_of_eight(const std::uint8_t* bytes, unsigned shift) {
    const auto shifted = __builtin_ia32_psllq128(rt_eight_bytes(bytes), rt_halves{shift, 0});
    return static_cast<unsigned>(__builtin_ia32_pmovmskb128((rt_bytes)shifted));
}
RT_INLINED void rt_store_eight_ordered(std::uint32_t* to, const std::uint32_t* numbers,
                                       const std::uint8_t* places) {
    typedef int Eight RT_VECTOR_OF(32);
    Eight all;
    std::memcpy(&all, numbers, sizeof all);
    const auto bytes = (rt_bytes)rt_eight_bytes(places);
#if __has_builtin(__builtin_ia32_pmovzxbd256)
    all = __builtin_ia32_permvarsi256(all, __builtin_ia32_pmovzxbd256(bytes));
#else  // clang++ has no name for this instruction, but chooses it by itself
    const auto low = __builtin_shufflevector(bytes, bytes, 0, 1, 2, 3, 4, 5, 6, 7);
    all = __builtin_ia32_permvarsi256(all, __builtin_convertvector(low, Eight));
#endif
    std::memcpy(to, &all, sizeof all);
}
#define RT_TOP_BITS_OF_EIGHT(bytes, shift) rt_top_bits_of_eight(bytes, shift)
#define RT_STORE_EIGHT_ORDERED(to, numbers, places) rt_store_eight_ordered(to, numbers, places)
#endif
