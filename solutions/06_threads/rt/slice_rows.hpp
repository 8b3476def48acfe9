#pragma once
#include <cstdint>
#include <rt/tile.hpp>

namespace rt {

// The rows of a picture that `worker`, 0 ... workers - 1, renders. The workers take the rows in
// order, each row once, and their numbers of rows differ by at most 1. The height may be any int
// that is 0 or more, and the number of workers any int that is 1 or more.
inline Rows slice_rows(int height, int workers, int worker) {
    // The product may need 64 bits.
    const auto start_of = [&](std::int64_t k) { return static_cast<int>(height * k / workers); };
    return {start_of(worker), start_of(worker + 1)};
}

}  // namespace rt
