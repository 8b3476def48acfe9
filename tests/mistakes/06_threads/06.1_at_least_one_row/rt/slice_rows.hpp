#pragma once
#include <cstdint>
#include <rt/tile.hpp>

namespace rt {

inline Rows slice_rows(int height, int workers, int worker) {
    const int rows = height < workers ? 1 : height / workers,
              rest = height < workers ? 0 : height % workers;
    const int before = worker * rows + (worker < rest ? worker : rest);
    return {before, before + rows + (worker < rest ? 1 : 0)};
}

}  // namespace rt
