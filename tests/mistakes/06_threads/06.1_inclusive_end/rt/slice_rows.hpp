#pragma once
#include <cstdint>
#include <rt/tile.hpp>

namespace rt {

inline Rows slice_rows(int height, int workers, int worker) {
    const auto start_of = [&](std::int64_t k) { return static_cast<int>(height * k / workers); };
    return {start_of(worker), start_of(worker + 1) - 1};
}

}  // namespace rt
