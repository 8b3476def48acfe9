#pragma once
#include <algorithm>
#include <atomic>
#include <optional>
#include <rt/run_workers.hpp>
#include <rt/tile.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 06.3. The number of tiles that cover the picture. It fits into an int, and is 0 if the
// width or the height is 0.
// Star: width, height and tile_size may be as large as the largest int.
inline int tile_count(const TileGrid& grid) {
    return rt::todo("06.3", grid);
}

// Exercise 06.3. The tile with number `index`, 0 ... tile_count(grid) - 1. The tiles are numbered
// row by row, from the top left. At the right and lower edges of the picture a tile ends where the
// picture ends.
// Star: width, height and tile_size may be as large as the largest int.
inline Tile tile_at(const TileGrid& grid, int index) {
    return rt::todo("06.3", grid, index);
}

// Exercise 06.3. Takes the next of `count` tiles: every index 0 ... count - 1 is returned to
// exactly one caller, and {} only after all are taken. The counter starts at 0; it may be any type
// that counts like std::atomic<int>. Between any two operations on the counter, another worker may
// take a tile.
template <class Counter>
std::optional<int> take_tile(Counter& next, int count) {
    return rt::todo("06.3", next, count);
}

// Exercise 06.3. A Strategy: whichever worker is free takes the next tile. Several pictures may be
// rendered at the same time.
// Star: an exception in a tile reaches the caller.
inline void render_tiles(const TileGrid& grid, int workers, const TileWork& work) {
    rt::todo("06.3", grid, workers, work);
}

}  // namespace rt
