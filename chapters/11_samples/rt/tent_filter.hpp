#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <rt/canvas.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/image.hpp>
#include <rt/pack.hpp>
#include <rt/sobol_points.hpp>
#include <rt/tile.hpp>

namespace rt {

// Sobol's points of a pixel (given). Instead of averaging the samples, KeptSamples calls
// keep(offset, light) for each of them.
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

// The samples of a tile, weighted with a tent as the reconstruction filter (given). A sample counts
// for every pixel whose middle is less than one pixel away, both across and down: at the distance
// (x, y), its weight is (1 - |x|) (1 - |y|). So each sample counts for four pixels, with weights
// that add up to 1. A pixel's color is the weighted mean of its samples.
class TentSums {
  public:
    explicit TentSums(const Tile& tile)
        : tile_{tile},
          sums_{tile.right - tile.left + 2 * border, tile.bottom - tile.top + 2 * border} {}

    // The pixels that are sampled, including those just outside of the tile, of which only the
    // samples that count for the tile are drawn. Each sample is the same for every tile, and
    // samples are added in the picture's order, so that a pixel's color does not depend on tiles or
    // threads.
    Tile sampled() const {
        return {tile_.left - 1, tile_.top - 1, tile_.right + 1, tile_.bottom + 1};
    }

    // Adds a sample at this offset in pixel (x, y).
    void add(int x, int y, Vec2 offset, const Color& light) {
        const int left = first_of_two(offset.x), top = first_of_two(offset.y);
        const Real right = offset.x - Real(0.5) - static_cast<Real>(left),
                   bottom = offset.y - Real(0.5) - static_cast<Real>(top);
        const Real rest = 1 - right;
        const Eight row = Eight{rest, rest, rest, rest, right, right, right, right} *
                          Eight{light.r, light.g, light.b, 1, light.r, light.g, light.b, 1};
        add(at(x + left, y + top), (1 - bottom) * row);
        add(at(x + left, y + top + 1), bottom * row);
    }

    void write(Image& image) {
        for_each_pixel(tile_, [&](int x, int y) {
            const auto [r, g, b, weight] = at(x, y);
            image.at(x, y) =
                Color{static_cast<Real>(r), static_cast<Real>(g), static_cast<Real>(b)} /
                static_cast<Real>(weight);
        });
    }

  private:
    // Red, green, blue and the weight, each added in double for the same reason as in ColorSum.
    using Sum = std::array<double, 4>;
    using Eight = PackOf<Real, 8>;  // for two neighboring pixels in a row
    using Sums = PackOf<double, 8>;
    // A sample may count for a pixel this far outside of the tile, too. There is room for such
    // pixels, so no test is needed.
    static constexpr int border = 1;

    Sum& at(int x, int y) { return sums_.at(x - tile_.left + border, y - tile_.top + border); }
    // Adds to a pixel's sum and to that of its right neighbor.
    static void add(Sum& sum, const Eight& terms) {
        double* const numbers = sum.data();
        Sums sums;
        std::memcpy(&sums, numbers, sizeof sums);
        sums += __builtin_convertvector(terms, Sums);
        std::memcpy(numbers, &sums, sizeof sums);
    }

    Tile tile_;
    Canvas<Sum> sums_;
};

// Draws a tile, filtered with a tent (given), path by path or in batches.
template <class AnyRenderer>
void draw_with_tent(const AnyRenderer& renderer, SobolSamples samples, const Tile& tile,
                    Image& image, std::uint64_t& rays) {
    TentSums sums{tile};
    samples.near = tile;
    for_each_pixel(sums.sampled(), [&](int x, int y) {
        const auto keep = [&](Vec2 offset, const Color& light) { sums.add(x, y, offset, light); };
        renderer(KeptSamples<decltype(keep)>{samples, keep}, x, y, rays);
    });
    sums.write(image);
}
template <Effects effects>
void draw_with_tent(BatchRenderer<effects, SobolPoints>& renderer, SobolSamples samples,
                    const Tile& tile, Image& image, std::uint64_t& rays) {
    TentSums sums{tile};
    samples.near = tile;
    renderer.each(
        {samples}, sums.sampled(), rays,
        [&](int x, int y, Vec2 offset, const Color& light) { sums.add(x, y, offset, light); });
    sums.write(image);
}

}  // namespace rt
