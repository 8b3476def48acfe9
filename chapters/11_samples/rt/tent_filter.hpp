#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <rt/canvas.hpp>
#include <rt/color_sum.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/image.hpp>
#include <rt/sobol_samples.hpp>
#include <rt/tile.hpp>

namespace rt {

// Sobol's points of a pixel (given), each handed over as keep(offset, light) instead of averaged.
template <class Keep>
struct KeptSamples {
    SobolSamples samples;
    const Keep& keep;

    template <class AnyCamera, class Path>
    Color average(const AnyCamera& camera, int column, int row, const Path& path) const {
        samples.each(camera, column, row, path, keep);
        return {};
    }
};

// Draws a tile with a tent as the reconstruction filter (given). A sample counts for all pixels
// whose middle is less than a pixel away, across and down: (1 - |x|) (1 - |y|) at the distance x,
// y. So four pixels share it, with weights that add up to 1. A pixel is the mean of its samples,
// weighted like that.
//
// Pixels just outside of the tile are sampled, too. Their samples are those that the next tile
// takes, and they are added in the picture's order: what a pixel becomes does not depend on tiles
// and threads.
template <class AnyRenderer>
void draw_with_tent(const AnyRenderer& renderer, const SobolSamples& samples, const Tile& tile,
                    Image& image, std::uint64_t& rays) {
    struct Sum {
        ColorSum light;
        double weight = 0;
    };
    Canvas<Sum> sums{tile.right - tile.left, tile.bottom - tile.top};
    const auto around = [](Real offset) { return offset < Real(0.5) ? -1 : 0; };
    const auto weight = [](Real offset, int pixel) {
        return 1 - std::abs(offset - Real(0.5) - static_cast<Real>(pixel));
    };
    for_each_pixel(
        {tile.left - 1, tile.top - 1, tile.right + 1, tile.bottom + 1}, [&](int x, int y) {
            const auto keep = [&](Vec2 offset, const Color& light) {
                for (int down = around(offset.y), j = down; j <= down + 1; ++j)
                    for (int right = around(offset.x), i = right; i <= right + 1; ++i) {
                        const int column = x + i - tile.left, row = y + j - tile.top;
                        if (column < 0 || row < 0 || column >= sums.width() || row >= sums.height())
                            continue;
                        const Real share = weight(offset.x, i) * weight(offset.y, j);
                        Sum& sum = sums.at(column, row);
                        sum.light.add(share * light);
                        sum.weight += static_cast<double>(share);
                    }
            };
            renderer(KeptSamples<decltype(keep)>{samples, keep}, x, y, rays);
        });
    for_each_pixel(tile, [&](int x, int y) {
        const Sum& sum = sums.at(x - tile.left, y - tile.top);
        image.at(x, y) = sum.light.mean(1) / static_cast<Real>(sum.weight);
    });
}

}  // namespace rt
