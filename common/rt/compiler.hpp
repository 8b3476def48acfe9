#pragma once
// The one header that may hold compiler-specific code.

// The file and line of the caller, when used as default arguments. They stand in for
// std::source_location, which clang 14 lacks; g++, clang++ and MSVC all have these two.
#define RT_CALLER_FILE __builtin_FILE()
#define RT_CALLER_LINE __builtin_LINE()

// Makes the compiler believe that somebody reads all of this value, and may have changed whatever
// memory holds: neither it nor the work that led to it can be left out or done once for all.
#define RT_KEEP(value) asm volatile("" : : "r"(&(value)) : "memory")

// For a function of a few loops over arrays, which compilers turn into wide instructions where it
// stands alone, but not always where it is copied into a larger loop.
#define RT_NOT_INLINED [[gnu::noinline]]

// For a small function in the middle of a loop: it is always copied there, so that what it computes
// stays in the processor's registers.
#define RT_INLINED [[gnu::always_inline]] inline

// For a function that is the whole of a hot loop: what it calls is copied into it, however many
// loops of its kind the program has, so that none of them runs slower than it would alone.
#define RT_INLINES_ALL [[gnu::flatten]]

// The bytes of the widest register that this program is compiled for, vectors of numbers that fill
// one, and a mask of such a vector, or of a shorter one (-1 or 0 each), as bits.
#define RT_VECTOR_OF(bytes) __attribute__((vector_size(bytes)))
#if defined(__SSE2__)
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
inline unsigned rt_vector_bits(Mask mask) {
    [[maybe_unused]] constexpr bool is_short = sizeof(mask[0]) == 4;
#if RT_REGISTER_BYTES == 64
    if constexpr (sizeof mask == 64) {
        if constexpr (is_short) return _mm512_movepi32_mask(reinterpret_cast<__m512i>(mask));
        else return _mm512_movepi64_mask(reinterpret_cast<__m512i>(mask));
    } else
#endif
#if RT_REGISTER_BYTES >= 32
    if constexpr (sizeof mask == 32) {
        if constexpr (is_short) return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
        else return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask)));
    } else
#endif
#if defined(__SSE2__)
    {
        if constexpr (is_short) return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
        else return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(mask)));
    }
#else
    {
        unsigned bits = 0;
        for (unsigned i = 0; i < sizeof mask / sizeof mask[0]; ++i) bits |= mask[i] ? 1u << i : 0;
        return bits;
    }
#endif
}
#define RT_VECTOR_BITS(mask) rt_vector_bits(mask)
