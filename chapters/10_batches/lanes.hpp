#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>

namespace batches {

// The chapter's picture, drawn by code that is compiled for registers of some width. The functions
// `singly` and `in_batches` return how many rays they took.
struct Width {
    std::size_t lanes = 1;  // the numbers that a register holds
    std::function<std::uint64_t()> singly, in_batches;
};

// Registers of at most 16 bytes, of at most 32 bytes, and as wide as the program is compiled for.
// The first two are never wider than the third.
Width registers_of_16_bytes();
Width registers_of_32_bytes();
Width registers_of_this_program();

}  // namespace batches
