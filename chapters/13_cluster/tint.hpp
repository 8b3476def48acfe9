#pragma once
#include <algorithm>
#include <app/figure.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/image.hpp>
#include <rt/render_tiles.hpp>
#include <string>
#include <vector>

namespace cluster {

// Tints each tile at the edge of the picture with the color of the rank that drew it, one of eight
// colors, and writes the rank's number into it. drawn_by[i] is the rank that drew tile i; if it is
// -1, the tile stays as it is.
inline void tint_edge(rt::Image& image, const rt::TileGrid& grid,
                      const std::vector<int>& drawn_by) {
    using rt::Color, rt::Real;
    constexpr Color colors[]{
        {Real(0.85), Real(0.10), Real(0.10)}, {Real(0.05), Real(0.35), Real(0.85)},
        {Real(0.95), Real(0.65), Real(0.05)}, {Real(0.05), Real(0.60), Real(0.25)},
        {Real(0.50), Real(0.15), Real(0.70)}, {Real(0.05), Real(0.65), Real(0.70)},
        {Real(0.90), Real(0.30), Real(0.60)}, {Real(0.45), Real(0.28), Real(0.12)}};
    app::Figure figure{image};
    for (int index = 0; index < rt::tile_count(grid); ++index) {
        const rt::Tile tile = rt::tile_at(grid, index);
        const bool at_edge = tile.left == 0 || tile.top == 0 || tile.right == grid.width ||
                             tile.bottom == grid.height;
        const int rank = drawn_by[static_cast<std::size_t>(index)];
        if (!at_edge || rank < 0) continue;
        rt::for_each_pixel(tile, [&](int x, int y) {
            Color& pixel = image.at(x, y);
            pixel = Real(0.35) * pixel + Real(0.65) * colors[rank % 8];
        });
        const rt::Vec2 middle{static_cast<Real>(tile.left + tile.right) / 2,
                              static_cast<Real>(tile.top + tile.bottom) / 2};
        const Real height =
            static_cast<Real>(std::min(tile.right - tile.left, tile.bottom - tile.top)) * Real(0.4);
        figure.words_around(middle, std::to_string(rank), {height, {1, 1, 1}});
    }
}

}  // namespace cluster
