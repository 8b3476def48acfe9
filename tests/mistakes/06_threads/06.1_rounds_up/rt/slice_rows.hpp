#pragma once
#include <cstdint>
#include <rt/tile.hpp>

namespace rt {

inline Rows slice_rows(int height, int workers, int worker) {
    const int rows = (height + workers - 1) / workers;
    return {worker * rows, (worker + 1) * rows};
}

}  // namespace rt
