#pragma once
// The answer's own, among all strategies.

#include <rt/tile.hpp>

namespace answer {

int tile_count(const rt::TileGrid& grid);
rt::Tile tile_at(const rt::TileGrid& grid, int index);
void render_tiles(const rt::TileGrid& grid, int workers, const rt::TileWork& work);

}  // namespace answer

namespace rt {

using answer::render_tiles;
using answer::tile_at;
using answer::tile_count;

}  // namespace rt
