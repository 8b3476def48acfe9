#pragma once
// The processor's wide registers, as far as it takes compiler-specific code.

#include <cstddef>
#include <cstring>
#include <rt/compiler.hpp>
#include <type_traits>

// Vectors that fill the widest register that this program is compiled for, the bytes of that
// register, and a mask of such a vector (each lane -1 or 0) as bits.
#define RT_VECTOR_OF(bytes) __attribute__((vector_size(bytes)))
#ifdef __SSE2__
#include <immintrin.h>
#endif
#if defined(__AVX512F__) && defined(__AVX512DQ__)
#define RT_REGISTER_BYTES 64
#elif defined(__AVX2__)
#define RT_REGISTER_BYTES 32
#else
#define RT_REGISTER_BYTES 16
#endif

template <class Mask>
inline unsigned rt_vector_bits(const Mask& mask) {
    constexpr std::size_t size = sizeof(Mask), count = size / sizeof(mask[0]);
    [[maybe_unused]] constexpr bool is_short = sizeof(mask[0]) == 4;
#ifdef __AVX512DQ__
    if constexpr (size == 64)
        return is_short ? _mm512_movepi32_mask((__m512i)mask) : _mm512_movepi64_mask((__m512i)mask);
#endif
#ifdef __AVX2__
    if constexpr (size == 32)
        return static_cast<unsigned>(is_short ? _mm256_movemask_ps((__m256)mask)
                                              : _mm256_movemask_pd((__m256d)mask));
#endif
#ifdef __SSE2__
    if constexpr (size == 16)
        return static_cast<unsigned>(is_short ? _mm_movemask_ps((__m128)mask)
                                              : _mm_movemask_pd((__m128d)mask));
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

// RT_TOP_BITS_OF_EIGHT: the top bits of eight bytes that are shifted left first.
// RT_STORE_EIGHT_ORDERED: stores eight 32-bit numbers in the order that `places` gives, in one
// instruction, where the processor has one.
#ifdef __AVX2__
#define RT_HAS_EIGHT_ORDERED
#define RT_TOP_BITS_OF_EIGHT(bytes, shift)                                                        \
    static_cast<unsigned>(                                                                        \
        _mm_movemask_epi8(_mm_sll_epi64(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(bytes)), \
                                        _mm_cvtsi32_si128(static_cast<int>(shift)))) &            \
        0xff)
#define RT_STORE_EIGHT_ORDERED(to, numbers, places)                        \
    _mm256_storeu_si256(                                                   \
        reinterpret_cast<__m256i*>(to),                                    \
        _mm256_permutevar8x32_epi32(                                       \
            _mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers)), \
            _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(places)))))
#endif
