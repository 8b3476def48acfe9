#pragma once
#include <cmath>
#include <rt/color_sum.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/image.hpp>
#include <rt/plain_batch.hpp>
#include <rt/primary_packs.hpp>
#include <rt/render_pixel.hpp>
#include <rt/sample_rng.hpp>
#include <rt/tile.hpp>
#include <vector>

namespace rt {

// The effects that batches have. Lights, fog, motion, instances and haze would take each path
// through chapter 08's code by itself, and that takes longer than to draw path by path.
inline constexpr Effects batch_effects{
    .mirror = true, .fuzz = true, .glass = true, .texture = true, .lens = true};

// The number of paths that make a bounce together. Their records should fit into the
// processor's second-level cache.
inline constexpr std::size_t batch_size = 4096;

// Draws tiles of a scene in batches of paths (given): all make their first bounce, then those that
// are left make their second, and so on. The picture is that of Renderer, bit for bit, however the
// paths are grouped into batches. Each thread has its own BatchRenderer.
template <Effects effects>
class BatchRenderer {
    static_assert(covers(batch_effects, effects));

  public:
    // The scene must outlive the renderer.
    BatchRenderer(const ReadyScene<effects>& scene, const Quality& quality,
                  std::size_t most_paths = batch_size)
        : scene_{scene},
          quality_{quality},
          batch_{scene, most_paths},
          points_(most_paths + pack_size),
          pixels_(most_paths) {
        while ((cells_ + 1) * (cells_ + 1) <= quality.samples_per_pixel) ++cells_;
        for (int cell = 0; cell < cells_; ++cell)
            ends_.push_back(
                std::nextafter(static_cast<Real>(cell + 1) / static_cast<Real>(cells_), Real(0)));
    }

    // The seed of everything random from now on.
    void set_seed(std::uint64_t seed) { quality_.seed = seed; }

    // Draws the pixels of a tile; the rays that it took are added to `rays`.
    void draw(const Tile& tile, Image& image, std::uint64_t& rays) {
        sums_.assign(static_cast<std::size_t>(pixel_count(tile)), {});
        ColorSum* next_sum = sums_.data();
        const std::uint64_t seed = quality_.seed;
        for_each_pixel(tile, [&](int column, int row) {
            ColorSum* const sum = next_sum++;
            Rng places = pixel_rng(seed, column, row);
            int sample = 0;
            const auto add = [&](Vec2 first, Vec2 end) {
                if (started_ == pixels_.size()) trace(rays);
                pixels_[started_] = sum;
                points_[started_] = {static_cast<Real>(column), static_cast<Real>(row), first,
                                     random_place(places), end};
                PathRecord& path = batch_.paths[started_];
                path.random = sample_rng(seed, column, row, sample++);
                path.sample = static_cast<std::int32_t>(started_++);
                path.throughput = {1, 1, 1};
            };
            for (int down = 0; down < cells_; ++down)
                for (int right = 0; right < cells_; ++right)
                    add({static_cast<Real>(right), static_cast<Real>(down)},
                        {end_of(right), end_of(down)});
            while (sample < quality_.samples_per_pixel) add({}, {infinity, infinity});
        });
        trace(rays);
        next_sum = sums_.data();
        for_each_pixel(tile, [&](int x, int y) {
            image.at(x, y) = next_sum++->mean(quality_.samples_per_pixel);
        });
    }

  private:
    // Where a path starts in the picture: at a place in a cell of a pixel (04.5).
    struct SamplePoint {
        Real column, row;
        Vec2 first;  // the cell's first corner, in cells
        Vec2 place;  // in the unit square
        Vec2 end;    // the largest offset in the cell
    };

    Real end_of(int cell) const { return ends_[static_cast<std::size_t>(cell)]; }

    // jittered_offset of 04.5: within a cell, or anywhere in the pixel if the cell has no end.
    Pack jittered(Pack first, Pack place, Pack end) const {
        const Pack within = min((first + place) / static_cast<Real>(cells_), end);
        return end == infinity ? place : within;
    }

    // Gives some paths their first rays.
    void start(std::size_t from, std::size_t size) {
        const auto [column, row, first_x, first_y, x, y, end_x, end_y] =
            load_eight([&](std::size_t i) { return &points_[from + i]; });
        const PixelPack pixel{
            column, row, {jittered(first_x, x, end_x), jittered(first_y, y, end_y)}};
        const auto [origin, direction] =
            primary_rays(scene_.camera, pixel, &batch_.paths[from], size);
        batch_.set_rays(from, origin, direction);
    }

    // Follows all paths of the batch to their ends.
    void trace(std::uint64_t& rays) {
        std::size_t left = started_;
        for (std::size_t i = 0; i < left; i += pack_size) start(i, std::min(pack_size, left - i));
        batch_.begin(left);
        for (int bounces = 1; left > 0; ++bounces)
            left = batch_.bounce(left, bounces == quality_.depth, rays);
        // Samples are added up in their order, as pixel_average does.
        for (std::size_t i = 0; i < started_; ++i) pixels_[i]->add(batch_.light[i]);
        started_ = 0;
    }

    const ReadyScene<effects>& scene_;
    Quality quality_;
    int cells_ = 1;           // in each row of a pixel
    std::vector<Real> ends_;  // the largest offset in each cell
    PlainBatch<effects> batch_;
    std::vector<ColorSum> sums_;  // of the tile's pixels
    std::vector<SamplePoint> points_;
    std::vector<ColorSum*> pixels_;  // of the batch's samples
    std::size_t started_ = 0;        // the number of samples in the batch
};

}  // namespace rt
