#pragma once
#include <cstdint>
#include <functional>

namespace rt {

// Rows begin, begin + 1, ... end - 1 of a picture; no rows if begin == end.
struct Rows {
    int begin = 0, end = 0;

    friend constexpr bool operator==(const Rows&, const Rows&) = default;
};

// A rectangle of pixels: columns left ... right - 1 of rows top ... bottom - 1.
struct Tile {
    int left = 0, top = 0, right = 0, bottom = 0;

    friend constexpr bool operator==(const Tile&, const Tile&) = default;
};

constexpr std::int64_t pixel_count(const Tile& tile) {
    return std::int64_t{tile.right - tile.left} * (tile.bottom - tile.top);
}

constexpr bool contains(const Tile& tile, int x, int y) {
    return tile.left <= x && x < tile.right && tile.top <= y && y < tile.bottom;
}

// A picture that is cut into square tiles, starting at its top left pixel. The tiles at the right
// and lower edges may be smaller. If a side of the picture is 0, there are no tiles.
struct TileGrid {
    int width = 0, height = 0;  // pixels
    int tile_size = 16;         // pixels, 1 or more
};

// The work on one tile. The workers are numbered 0, 1, 2, ...; no two calls with the same number
// overlap in time, so each worker may have memory of its own without a lock.
using TileWork = std::function<void(const Tile& tile, int worker)>;

// A way to spread the work over `workers` threads, 1 or more: every pixel lies in exactly one of
// the tiles for which work is called. Returns when all work is done. If `work` throws an exception,
// it reaches the caller after the last call has ended.
using Strategy = void (*)(const TileGrid& grid, int workers, const TileWork& work);

}  // namespace rt
