#pragma once
#include <app/run.hpp>
#include <rt/false_colors.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/tile.hpp>

namespace app {

// The Strategy of programs that do not use threads.
inline void one_row_after_another(const rt::TileGrid& grid, int, const rt::TileWork& work) {
    for (int y = 0; y < grid.height; ++y) work({0, y, grid.width, y + 1}, 0);
}

// Draws what --show asks for, in false colors (given): compute(column, row) gives the rt::Shown of
// each pixel. It fills the whole picture, whatever panels the chapter's own picture has. Like
// app::fill, it is only for programs.
template <class Compute>
Picture show(const Settings& settings, Progress& progress, const Compute& compute,
             rt::Strategy strategy = one_row_after_another) {
    const int width = settings.width, height = settings.height;
    std::vector<rt::Shown> pixels(static_cast<std::size_t>(width) *
                                  static_cast<std::size_t>(height));
    progress.start(height);
    strategy({width, height}, settings.threads, [&](const rt::Tile& tile, int) {
        rt::for_each_pixel(tile, [&](int x, int y) {
            pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)] = compute(x, y);
            if (x == width - 1) progress.step();
        });
    });
    auto [image, words] =
        rt::false_colors(width, height, pixels, rt::shown_words().at(settings.show));
    return {std::move(image), 0, [words = words] { return words; }};
}

}  // namespace app
