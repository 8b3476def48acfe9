// The renderer that draws jittered samples in batches.

#include "batched.hpp"

#include "batch_workers.hpp"
#include "tile_workers.hpp"

namespace full_renderer {

using namespace rt;

std::function<DrawSeed()> jittered_batches(const SceneDescription& scene, int width, int height,
                                           const Quality& quality) {
    return batch_workers<JitteredPoints>(
        scene, width, height, quality,
        [count = quality.samples_per_pixel](auto& renderer, const Tile& tile, std::uint64_t seed,
                                            Image& image, std::uint64_t& rays) {
            renderer.draw(JitteredPoints{{seed, count}}, tile, image, rays);
        });
}

TileWorkers make_batched(const MeshedDescription& scene, int width, int height,
                         const Quality& quality) {
    if (!can_be_batched(scene)) return make_path_by_path(scene, width, height, quality);
    const auto make_worker = [make = jittered_batches(scene, width, height, quality),
                              seed = quality.seed] {
        return [draw = make(), seed](const Tile& tile, Image& image, std::uint64_t& rays) {
            draw(tile, seed, image, rays);
            return pixel_count(tile);
        };
    };
    return {{batch_effects, "in batches"}, make_worker, batch_tile_side(quality.samples_per_pixel)};
}

}  // namespace full_renderer
