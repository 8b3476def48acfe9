#pragma once
#include <algorithm>
#include <atomic>
#include <optional>
#include <rt/run_workers.hpp>
#include <rt/tile.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 06.3. How many tiles cover the picture, which fits an int; 0 where a side has no pixels.
inline int tile_count(const TileGrid& grid) {
    return rt::todo("06.3", grid);
}

// Exercise 06.3. Tile 0 ... tile_count(grid) - 1, row by row from the top left one. At the right
// and at the lower edge of the picture a tile holds only the pixels that there are.
inline Tile tile_at(const TileGrid& grid, int index) {
    return rt::todo("06.3", grid, index);
}

// Exercise 06.3. Takes the next of `count` tiles: every index 0 ... count - 1 is returned to one
// caller alone, and none only when all are taken. The counter starts at 0; it may be any type that
// counts as std::atomic<int> does. Between any two steps on it another worker may take a tile.
template <class Counter>
std::optional<int> take_tile(Counter& next, int count) {
    return rt::todo("06.3", next, count);
}

// Exercise 06.3. A Strategy: whoever is free takes the next tile. Several pictures may be rendered
// at the same time.
inline void render_tiles(const TileGrid& grid, int workers, const TileWork& work) {
    rt::todo("06.3", grid, workers, work);
}

}  // namespace rt
