#include <answer.hpp>
#include <rt/render_tiles.hpp>

#include "types.hpp"

namespace answer EXPORTED {

int tile_count(const rt::TileGrid& grid) {
    return rt::tile_count(grid);
}

rt::Tile tile_at(const rt::TileGrid& grid, int index) {
    return rt::tile_at(grid, index);
}

std::optional<int> take_tile(std::atomic<int>& next, int count) {
    return rt::take_tile(next, count);
}

std::optional<int> take_tile(HauntedCounter& next, int count) {
    return rt::take_tile(next, count);
}

void render_tiles(const rt::TileGrid& grid, int workers, const rt::TileWork& work) {
    rt::render_tiles(grid, workers, work);
}

}  // namespace EXPORTED
