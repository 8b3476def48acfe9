#pragma once
// A tile, drawn by the threads of one rank.

#include <app/run.hpp>
#include <atomic>
#include <rt/canvas.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/render_tiles.hpp>
#include <thread>
#include <vector>

#include "tile_workers.hpp"

namespace cluster {

// Draws tiles of a scene path by path, as chapter 08's program does. Each tile is divided into
// smaller tiles, which the threads share out as in 06.3.
class TileDrawer {
  public:
    // The scene must outlive the drawer. `threads` is 1 or more.
    TileDrawer(const rt::MeshedDescription& scene, int threads)
        : threads_{threads},
          image_{rt::Canvas<rt::Color>{scene.settings.width, scene.settings.height}},
          renderer_{make_renderer(scene)},
          workers_(static_cast<std::size_t>(threads)) {}

    // Draws a tile, and returns its pixels, row by row. Adds the number of rays to `rays`.
    std::vector<rt::Color> draw(const rt::Tile& tile, std::uint64_t& rays) {
        const rt::TileGrid parts{tile.right - tile.left, tile.bottom - tile.top,
                                 renderer_.tile_side};
        std::atomic<std::uint64_t> all_rays = 0;
        rt::render_tiles(parts, threads_, [&](rt::Tile part, int worker) {
            part = {tile.left + part.left, tile.top + part.top, tile.left + part.right,
                    tile.top + part.bottom};
            rt::DrawTile& draw_part = workers_[static_cast<std::size_t>(worker)];
            if (!draw_part) draw_part = renderer_.make_worker();
            std::uint64_t part_rays = 0;
            draw_part(part, image_, part_rays);
            all_rays += part_rays;
        });
        rays += all_rays;
        std::vector<rt::Color> pixels;
        rt::for_each_pixel(tile, [&](int x, int y) { pixels.push_back(image_.at(x, y)); });
        return pixels;
    }

  private:
    static full_renderer::TileWorkers make_renderer(const rt::MeshedDescription& scene) {
        const auto& [width, height, samples, depth, seed] = scene.settings;
        return full_renderer::make_path_by_path(scene, width, height, {samples, depth, seed});
    }

    int threads_;
    rt::Image image_;  // each tile is drawn here, at its place in the picture
    full_renderer::TileWorkers renderer_;
    std::vector<rt::DrawTile> workers_;
};

}  // namespace cluster
