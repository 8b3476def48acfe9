#pragma once
// All compiler-specific code is here, except the code for the processor's wide registers, which is
// in <rt/vector_registers.hpp>.

// The file and line of the caller, when used as default arguments. They stand in for
// std::source_location, which clang 14 lacks; g++, clang++ and MSVC all have these two.
#define RT_CALLER_FILE __builtin_FILE()
#define RT_CALLER_LINE __builtin_LINE()

// Makes the compiler assume that this whole value is read here, and that all of memory may have
// changed. So the compiler can neither leave out the computation of the value nor do it only once
// for all repetitions.
#define RT_KEEP(value) asm volatile("" : : "r"(&(value)) : "memory")

// For a function that consists of a few loops over arrays. Compilers turn such loops into wide
// instructions if the function is compiled by itself, but not always if it is inlined into a larger
// loop.
#define RT_NOT_INLINED [[gnu::noinline]]

// For a small function in the middle of a loop: it is always inlined there, so that its results
// stay in the processor's registers.
#define RT_INLINED [[gnu::always_inline]] inline

// For a function that consists of a hot loop: everything that it calls is inlined into it. So even
// if the program has many such loops, each is as fast as it would be alone.
#define RT_INLINES_ALL [[gnu::flatten]]

// Asks for the memory around an address, which will be read soon.
#define RT_PREFETCH(address) __builtin_prefetch(address)
