#pragma once
#include <rt/canvas.hpp>
#include <rt/choose_renderer.hpp>
#include <rt/color_sum.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/image.hpp>
#include <rt/jittered_points.hpp>
#include <rt/plain_batch.hpp>
#include <rt/primary_packs.hpp>
#include <rt/render_pixel.hpp>
#include <rt/sample_rng.hpp>
#include <rt/tile.hpp>
#include <vector>

namespace rt {

// The effects that can be drawn in batches. With lights, fog, motion, instances or haze, each path
// of a batch would go through chapter 08's code by itself, and the picture would take longer than
// if it were drawn path by path.
inline constexpr Effects batch_effects{
    .mirror = true, .fuzz = true, .glass = true, .texture = true, .lens = true};

inline bool can_be_batched(const SceneDescription& scene) {
    return covers(batch_effects, needed_effects(scene));
}

// The number of paths that make a bounce together. Their records should fit into the
// processor's second-level cache.
inline constexpr std::size_t batch_size = 4096;

// The side of the smallest tiles with enough paths for a batch.
inline int batch_tile_side(int samples_per_pixel) {
    int side = 16;
    while (static_cast<std::size_t>(side * side) * static_cast<std::size_t>(samples_per_pixel) <
           batch_size)
        side *= 2;
    return side;
}

// Draws tiles of a scene in batches of paths (given): all paths of a batch make their first bounce,
// then those that have not ended make their second bounce, and so on. The picture is the same as
// that of Renderer, bit for bit, however the paths are grouped into batches. Each thread has its
// own BatchRenderer.
//
// `Points` tells where the samples are, and provides their random numbers: see JitteredPoints.
template <Effects effects, class Points = JitteredPoints>
class BatchRenderer {
    static_assert(covers(batch_effects, effects));

  public:
    // The scene must outlive the renderer.
    BatchRenderer(const ReadyScene<effects>& scene, const Quality& quality,
                  std::size_t most_paths = batch_size)
        : scene_{scene},
          quality_{quality},
          batch_{scene, most_paths},
          points_(most_paths + pack_size) {}

    // Draws the pixels of a tile, with the samples that the quality asks for or with `points`. Adds
    // the number of rays to `rays`.
    void draw(const Tile& tile, Image& image, std::uint64_t& rays) {
        draw(Points{{quality_.seed, quality_.samples_per_pixel}}, tile, image, rays);
    }
    void draw(const Points& points, const Tile& tile, Image& image, std::uint64_t& rays) {
        Canvas<ColorSum> sums{tile.right - tile.left, tile.bottom - tile.top};
        each(points, tile, rays, [&](int x, int y, Vec2, const Color& light) {
            sums.at(x - tile.left, y - tile.top).add(light);
        });
        for_each_pixel(tile, [&](int x, int y) {
            image.at(x, y) = sums.at(x - tile.left, y - tile.top).mean(points.count());
        });
    }

    // Calls keep(x, y, place, light) for each sample of a tile's pixels, in order.
    template <class Keep>
    void each(const Points& points, const Tile& tile, std::uint64_t& rays, const Keep& keep) {
        cells_ = points.cells();
        const auto add = [&](const auto&... of_random) -> Start {
            if (batch_.randoms.size() == batch_.light.size()) trace(rays, keep);
            const std::size_t number = batch_.randoms.size();
            PathRecord& path = batch_.paths[number];
            path.sample = static_cast<std::int32_t>(number);
            path.throughput = {1, 1, 1};
            return {points_[number], batch_.randoms.emplace_back(of_random...)};
        };
        for_each_pixel(tile, [&](int x, int y) { points.each(x, y, add); });
        trace(rays, keep);
    }

  private:
    // References to a sample's point and its generator, which are written in place: copying them
    // would take extra time.
    struct Start {
        SamplePoint& point;
        typename Points::Random& random;
    };

    // jittered_offset of 04.5: within a cell, or anywhere in the pixel if `end` is infinite.
    Pack jittered(Pack first, Pack place, Pack end) const {
        const Pack within = min((first + place) / static_cast<Real>(cells_), end);
        return end == infinity ? place : within;
    }

    // Sets the first rays of `size` paths, beginning with path number `from`.
    RT_INLINES_ALL void start(std::size_t from, std::size_t size) {
        const auto [column, row, first_x, first_y, x, y, end_x, end_y] =
            load_eight([&](std::size_t i) { return &points_[from + i]; });
        const PixelPack pixel{
            column, row, {jittered(first_x, x, end_x), jittered(first_y, y, end_y)}};
        const auto random = [&](std::size_t i) -> auto& {
            return batch_.randoms[from + i];
        };
        const auto [origin, direction] = primary_rays(scene_.camera, pixel, random, size);
        batch_.set_rays(from, origin, direction);
    }

    // Follows all paths of the batch to their ends.
    template <class Keep>
    void trace(std::uint64_t& rays, const Keep& keep) {
        const std::size_t all = batch_.randoms.size();
        std::size_t left = all;
        for (std::size_t i = 0; i < left; i += pack_size) start(i, std::min(pack_size, left - i));
        batch_.begin(left);
        for (int bounces = 1; left > 0; ++bounces)
            left = batch_.bounce(left, bounces == quality_.depth, rays);
        for (std::size_t i = 0; i < all; ++i) {
            const SamplePoint& point = points_[i];
            keep(static_cast<int>(point.column), static_cast<int>(point.row), point.place,
                 batch_.light[i]);
        }
        batch_.randoms.clear();
    }

    const ReadyScene<effects>& scene_;
    Quality quality_;
    PlainBatch<effects, typename Points::Random> batch_;
    std::vector<SamplePoint> points_;  // of the batch's samples
    int cells_ = 1;                    // in each row of a pixel
};

}  // namespace rt
