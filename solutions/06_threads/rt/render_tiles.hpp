#pragma once
#include <algorithm>
#include <atomic>
#include <optional>
#include <rt/run_workers.hpp>
#include <rt/tile.hpp>

namespace rt {

// How many tiles it takes to cover this many pixels in one direction. The number of pixels is 0 or
// more.
inline int tiles_along(int pixels, int tile_size) {
    return pixels / tile_size + (pixels % tile_size != 0);
}

inline int tile_count(const TileGrid& grid) {
    return tiles_along(grid.width, grid.tile_size) * tiles_along(grid.height, grid.tile_size);
}

// The tile with number `index`, 0 ... tile_count(grid) - 1. The tiles are numbered row by row, from
// the top left.
inline Tile tile_at(const TileGrid& grid, int index) {
    const int columns = tiles_along(grid.width, grid.tile_size);
    const int left = index % columns * grid.tile_size, top = index / columns * grid.tile_size;
    // Compares the pixels that remain, because left + tile_size might not fit an int.
    return {left, top, left + std::min(grid.tile_size, grid.width - left),
            top + std::min(grid.tile_size, grid.height - top)};
}

// Takes the next of `count` tiles: every index 0 ... count - 1 is returned to exactly one caller,
// and {} only after all are taken. The counter starts at 0; it may be any type that counts like
// std::atomic<int>.
template <class Counter>
std::optional<int> take_tile(Counter& next, int count) {
    // Reads and adds 1 in a single step, which no other worker can interrupt.
    const int mine = next.fetch_add(1);
    if (mine < count) return mine;
    return {};
}

// A Strategy: whichever worker is free takes the next tile.
inline void render_tiles(const TileGrid& grid, int workers, const TileWork& work) {
    std::atomic<int> next = 0;
    const int count = tile_count(grid);
    run_workers(workers, [&](int worker) {
        while (const std::optional<int> index = take_tile(next, count))
            work(tile_at(grid, *index), worker);
    });
}

}  // namespace rt
