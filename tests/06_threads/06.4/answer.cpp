#include <answer.hpp>
#include <rt/render_slices.hpp>
#include <rt/render_tiles.hpp>
#include <rt/sample_rng.hpp>

namespace answer EXPORTED {

rt::Rng sample_rng(std::uint64_t seed, int x, int y, int sample) {
    return rt::sample_rng(seed, x, y, sample);
}

rt::Color average_samples(std::uint64_t seed, int x, int y, int samples,
                          const std::function<rt::Color(int, rt::Rng&)>& draw) {
    return rt::average_samples(seed, x, y, samples, draw);
}

void render_slices(const rt::TileGrid& grid, int workers, const rt::TileWork& work) {
    rt::render_slices(grid, workers, work);
}

int tile_count(const rt::TileGrid& grid) {
    return rt::tile_count(grid);
}

rt::Tile tile_at(const rt::TileGrid& grid, int index) {
    return rt::tile_at(grid, index);
}

void render_tiles(const rt::TileGrid& grid, int workers, const rt::TileWork& work) {
    rt::render_tiles(grid, workers, work);
}

}  // namespace EXPORTED
