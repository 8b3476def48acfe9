// The part of chapter 08's program that draws jittered samples in batches, for the option
// --batches. This file is linked into that program.

#include <rt/batch_workers.hpp>

#include "tile_renderer.hpp"

effects::TileRenderer effects::make_batched(const rt::SceneDescription& scene, int width,
                                            int height, const rt::Quality& quality) {
    using namespace rt;
    if (!can_be_batched(scene)) return make_path_by_path(scene, width, height, quality);
    const int count = quality.samples_per_pixel;
    const auto draw = [count](auto& renderer, const Tile& tile, std::uint64_t seed, Image& image,
                              std::uint64_t& rays) {
        renderer.draw(JitteredPoints{{seed, count}}, tile, image, rays);
        return pixel_count(tile);
    };
    return {batched_choice(batch_effects),
            batch_workers<JitteredPoints>(scene, width, height, quality, draw),
            batch_tile_side(count)};
}
