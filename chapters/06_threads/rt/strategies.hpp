#pragma once
#include <rt/for_each_pixel.hpp>
#include <rt/image.hpp>
#include <rt/parallel_jobs.hpp>
#include <rt/render_slices.hpp>
#include <rt/render_tiles.hpp>
#include <rt/tile.hpp>
#include <string>
#include <vector>

namespace rt {

// Renders the tiles of 06.3, but std::for_each(std::execution::par, ...) hands them out (given).
inline void render_with_standard_algorithm(const TileGrid& grid, int workers,
                                           const TileWork& work) {
    spread_by_standard_algorithm()(tile_count(grid), workers, [&](int index, int worker) {
        work(tile_at(grid, index), worker);
    });
}

// Renders the tiles of 06.3, but OpenMP hands them out (given).
inline void render_with_openmp(const TileGrid& grid, int workers, const TileWork& work) {
    spread_by_openmp()(tile_count(grid), workers,
                       [&](int index, int worker) { work(tile_at(grid, index), worker); });
}

struct NamedStrategy {
    std::string name;
    Strategy render;
};

// All strategies that this build has (given): those of the exercises first.
inline std::vector<NamedStrategy> strategies() {
    std::vector<NamedStrategy> all{{"slices", render_slices}, {"tiles", render_tiles}};
    if (spread_by_standard_algorithm())
        all.push_back({"execution::par", render_with_standard_algorithm});
    if (spread_by_openmp()) all.push_back({"OpenMP", render_with_openmp});
    return all;
}

// A picture, rendered by a strategy (given): shade(x, y, worker) gives the Color of each pixel.
template <class Shade>
Image render_image(Strategy strategy, const TileGrid& grid, int workers, const Shade& shade) {
    Image image{grid.width, grid.height};
    strategy(grid, workers, [&](const Tile& tile, int worker) {
        for_each_pixel(tile, [&](int x, int y) { image.at(x, y) = shade(x, y, worker); });
    });
    return image;
}

}  // namespace rt
