#pragma once
#include <optional>
#include <rt/tile.hpp>

#include "../types.hpp"

namespace answer {

int tile_count(const rt::TileGrid& grid);
rt::Tile tile_at(const rt::TileGrid& grid, int index);
std::optional<int> take_tile(std::atomic<int>& next, int count);
std::optional<int> take_tile(HauntedCounter& next, int count);
void render_tiles(const rt::TileGrid& grid, int workers, const rt::TileWork& work);

}  // namespace answer

namespace rt {

using answer::render_tiles;
using answer::take_tile;
using answer::tile_at;
using answer::tile_count;

}  // namespace rt
