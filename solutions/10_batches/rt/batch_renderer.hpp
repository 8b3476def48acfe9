#pragma once
#include <rt/for_each_pixel.hpp>
#include <rt/image.hpp>
#include <rt/jitter.hpp>
#include <rt/lit_batch.hpp>
#include <rt/plain_batch.hpp>
#include <rt/primary_packs.hpp>
#include <rt/render_pixel.hpp>
#include <rt/sample_rng.hpp>
#include <rt/tile.hpp>
#include <type_traits>

namespace rt {

// How many paths make a bounce together. Their records should fit into the processor's second
// cache.
inline constexpr std::size_t batch_size = 2048;

// Draws tiles of a scene in batches of paths (given): all make their first bounce, then all that
// are left their second one, and so on. The picture is that of Renderer, bit for bit, however the
// paths are put into batches. Each thread has one of its own.
template <Effects effects>
class BatchRenderer {
  public:
    // The scene must outlive the renderer.
    BatchRenderer(const ReadyScene<effects>& scene, const Quality& quality,
                  std::size_t most_paths = batch_size)
        : scene_{scene}, quality_{quality}, batch_{scene, most_paths} {
        while ((cells_ + 1) * (cells_ + 1) <= quality.samples_per_pixel) ++cells_;
    }

    // Draws the pixels of a tile; the rays that it took are added to `rays`.
    void draw(const Tile& tile, Image& image, std::uint64_t& rays) {
        for_each_pixel(tile, [&](int column, int row) {
            image.at(column, row) = {};
            Rng places = pixel_rng(quality_.seed, column, row);
            for (int sample = 0; sample < quality_.samples_per_pixel; ++sample) {
                add_path(column, row, sample, random_place(places));
                pixels_.push_back(&image.at(column, row));
                if (pixels_.size() == batch_.paths.size()) trace(rays);
            }
        });
        trace(rays);
        const auto samples = static_cast<Real>(quality_.samples_per_pixel);
        for_each_pixel(tile, [&](int x, int y) { image.at(x, y) /= samples; });
    }

  private:
    // A path before it begins: where its record will have a ray, it has a place of the picture.
    void add_path(int column, int row, int sample, Vec2 place) {
        const bool in_cell = sample < cells_ * cells_;
        const Vec2 offset = in_cell ? jittered_offset(sample, cells_, place) : place;
        PathRecord& path = batch_.paths[pixels_.size()];
        path = {};
        path.origin = {static_cast<Real>(column), static_cast<Real>(row), 0};
        path.direction = {offset.x, offset.y, 0};
        path.random = sample_rng(quality_.seed, column, row, sample);
        path.sample = static_cast<std::int32_t>(pixels_.size());
    }

    // Gives some paths their first rays.
    void start(std::size_t from, std::size_t size) {
        PathRecord* const paths = &batch_.paths[from];
        const auto record = [&](std::size_t i) { return &paths[i]; };
        const auto place = load_eight(size, record);
        const auto [origin, direction] =
            primary_rays(scene_.eye, {place[0], place[1], {place[3], place[4]}}, paths, size);
        store_eight({origin.x, origin.y, origin.z, direction.x, direction.y, direction.z,
                     pack_of(infinity), std::bit_cast<Pack>(PackMask{} - 1)},
                    size, record);
        if constexpr (effects.motion)
            for (std::size_t i = 0; i < size; ++i)
                batch_.times[from + i] =
                    scene_.eye.anything_moves ? paths[i].random.uniform() : Real(0);
    }

    // Follows all paths of the batch to their ends.
    void trace(std::uint64_t& rays) {
        std::size_t left = pixels_.size();
        for (std::size_t i = 0; i < left; i += pack_size) start(i, std::min(pack_size, left - i));
        batch_.begin(left);
        for (int bounces = 1; left > 0; ++bounces)
            left = batch_.bounce(left, bounces == quality_.depth, rays);
        // Samples are added up in their order, as pixel_average does.
        for (std::size_t i = 0; i < pixels_.size(); ++i) *pixels_[i] += batch_.light[i];
        pixels_.clear();
    }

    const ReadyScene<effects>& scene_;
    Quality quality_;
    int cells_ = 1;  // in a row of a pixel
    std::conditional_t<effects.lights || effects.fog, LitBatch<effects>, PlainBatch<effects>>
        batch_;
    std::vector<Color*> pixels_;  // of the batch's samples
};

}  // namespace rt
