// What chapter 08's program draws with if --batches is given. It is linked into that program.

#include <memory>
#include <rt/batch_renderer.hpp>

#include "tile_renderer.hpp"

namespace batches {
namespace {

using namespace rt;
using effects::DrawTile;

std::function<DrawTile()> make_workers(const SceneDescription& description, int width, int height,
                                       const Quality& quality) {
    const auto scene =
        std::make_shared<const ReadyScene<batch_effects>>(description, width, height);
    return [scene, quality] {
        const int count = quality.samples_per_pixel;
        const auto renderer = std::make_shared<BatchRenderer<batch_effects>>(*scene, quality);
        return [scene, count, renderer](const Tile& tile, std::uint64_t seed, Image& image,
                                        std::uint64_t& rays) {
            renderer->draw(JitteredPoints{{seed, count}}, tile, image, rays);
            return pixel_count(tile);
        };
    };
}

}  // namespace
}  // namespace batches

effects::TileRenderer effects::make_batched(const rt::SceneDescription& scene, int width,
                                            int height, const rt::Quality& quality) {
    if (!rt::can_be_batched(scene)) return make_path_by_path(scene, width, height, quality);
    return {batched_choice(rt::batch_effects), batches::make_workers(scene, width, height, quality),
            rt::batch_tile_side(quality.samples_per_pixel)};
}
