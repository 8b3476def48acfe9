#pragma once
#include <rt/run_workers.hpp>
#include <rt/slice_rows.hpp>
#include <rt/tile.hpp>

namespace rt {

// A Strategy: each worker renders one tile, its slice of the rows over the full width. A worker
// without rows makes no call; in a picture without columns, no worker does.
inline void render_slices(const TileGrid& grid, int workers, const TileWork& work) {
    run_workers(workers, [&](int worker) {
        const Rows rows = slice_rows(grid.height, workers, worker);
        if (rows.begin < rows.end && grid.width > 0)
            work({0, rows.begin, grid.width, rows.end}, worker);
    });
}

}  // namespace rt
