#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>

namespace batches {

// Code that is compiled for registers of one width. `singly` draws the study's picture path by
// path, and `in_batches` in batches; both return the number of rays.
struct Width {
    std::size_t lanes = 1;  // how many numbers a register holds
    std::function<std::uint64_t()> singly, in_batches;
};

// The code for registers of at most 16 bytes, for registers of at most 32 bytes, and for those of
// the rest of the program, which are never narrower than the others.
Width registers_of_16_bytes();
Width registers_of_32_bytes();
Width registers_of_this_program();

}  // namespace batches
