#pragma once
#include <app/run.hpp>
#include <atomic>
#include <cassert>
#include <functional>
#include <memory>
#include <rt/canvas.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/image.hpp>
#include <rt/render_tiles.hpp>
#include <utility>

namespace rt {

// Draws a picture tile by tile with this many threads, until it is finished or a signal comes
// (given). draw(tile, worker, image, rays) adds the rays that a tile took to `rays`, and returns
// how many of its pixels are done.
template <class Draw>
app::Picture draw_by_tiles(const TileGrid& grid, int threads, app::Progress& progress,
                           const Draw& draw) {
    Image image = Canvas<Color>{grid.width, grid.height};
    app::draw_unfinished(image);
    std::atomic<std::uint64_t> all_rays = 0;
    std::atomic<std::int64_t> pixels_done = 0;
    const app::Interruption interruption;
    progress.start(tile_count(grid));
    render_tiles(grid, threads, [&](const Tile& tile, int worker) {
        if (app::Interruption::signal() != 0) return;
        std::uint64_t rays = 0;
        pixels_done += draw(tile, worker, image, rays);
        all_rays += rays;
        progress.step();
    });
    app::Picture picture{std::move(image), all_rays};
    if (const int signal = app::Interruption::signal()) {
        const auto all = static_cast<double>(picture.image.pixels().size());
        picture.stopped = {signal, static_cast<double>(pixels_done) / all};
    }
    return picture;
}

// Draws a tile pixel by pixel, until it is finished or a signal comes (given): color(x, y) gives
// the colors. Returns how many pixels are done.
template <class ColorOf>
std::int64_t draw_pixels(const Tile& tile, Image& image, const ColorOf& color) {
    std::int64_t done = 0;
    for_each_pixel(tile, [&](int x, int y) {
        if (app::Interruption::signal() != 0) return;
        image.at(x, y) = color(x, y);
        assert(is_finite(image.at(x, y)));
        ++done;
    });
    return done;
}

// Draws a picture pixel by pixel, in tiles of 16 x 16, with a renderer that all threads share
// (given). renderer(x, y, rays) is the color of a pixel, and adds the number of rays to `rays`.
template <class AnyRenderer>
app::Picture draw_with(const AnyRenderer& renderer, const app::Settings& settings,
                       app::Progress& progress) {
    return draw_by_tiles({settings.width, settings.height, 16}, settings.threads, progress,
                         [&](const Tile& tile, int, Image& image, std::uint64_t& rays) {
                             return draw_pixels(tile, image,
                                                [&](int x, int y) { return renderer(x, y, rays); });
                         });
}

// Draws the pixels of a tile, and returns how many are done: all, unless a signal came meanwhile
// (app::Interruption) and the function stops at signals. Adds the number of rays to `rays`.
using DrawTile = std::function<std::int64_t(const Tile&, Image& image, std::uint64_t& rays)>;

// The color of the pixel in column x of row y of a picture. Adds the number of rays to `rays`.
using PixelColor = std::function<Color(int x, int y, std::uint64_t& rays)>;

// The colors that a renderer computes; keeps the renderer alive.
template <class AnyRenderer>
PixelColor color_by(std::shared_ptr<const AnyRenderer> renderer) {
    return [renderer](int x, int y, std::uint64_t& rays) { return (*renderer)(x, y, rays); };
}

// Draws tiles pixel by pixel.
inline DrawTile pixel_by_pixel(PixelColor color) {
    return [color = std::move(color)](const Tile& tile, Image& image, std::uint64_t& rays) {
        return draw_pixels(tile, image, [&](int x, int y) { return color(x, y, rays); });
    };
}

}  // namespace rt
