#pragma once
#include <rt/run_workers.hpp>
#include <rt/slice_rows.hpp>
#include <rt/tile.hpp>

namespace rt {

inline void render_slices(const TileGrid& grid, int workers, const TileWork& work) {
    run_workers(workers, [&](int worker) {
        const Rows rows = slice_rows(grid.height, workers, worker);
        work({0, rows.begin, grid.width, rows.end}, worker);
    });
}

}  // namespace rt
