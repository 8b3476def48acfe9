#pragma once
#define render_tiles render_tiles_unrecorded
#include_next <rt/render_tiles.hpp>
#undef render_tiles
#include <rt/record.hpp>

namespace rt {

inline void render_tiles(const TileGrid& grid, int workers, const TileWork& work) {
    recorder::record().note("the call", "the number of threads", workers);
    recorder::record().note("the grid", "the grid's width", grid.width);
    recorder::record().note("the grid", "the grid's height", grid.height);
    render_tiles_unrecorded(grid, workers, work);
}

}  // namespace rt
