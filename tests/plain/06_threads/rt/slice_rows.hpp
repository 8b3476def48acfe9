#pragma once
#include <rt/tile.hpp>

namespace rt {
inline Rows slice_rows(int height, int workers, int worker) {
    return {height * worker / workers, height * (worker + 1) / workers};
}
}  // namespace rt
