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

// For a function that is the whole of a hot loop: what it calls is copied into it, however many
// loops of its kind the program has, so that none of them runs slower than it would alone.
#define RT_INLINES_ALL [[gnu::flatten]]

// For a small function in the middle of a loop: it is always copied there, so that what it computes
// stays in the processor's registers.
#define RT_INLINED [[gnu::always_inline]] inline
