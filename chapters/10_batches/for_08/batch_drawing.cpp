// What chapter 08's program draws with if --batches is given. It is linked into that program.

#include <memory>
#include <rt/batch_renderer.hpp>
#include <rt/needed_effects.hpp>

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
        const auto renderer = std::make_shared<BatchRenderer<batch_effects>>(*scene, quality);
        return [scene, renderer](const Tile& tile, std::uint64_t seed, Image& image,
                                 std::uint64_t& rays) {
            renderer->set_seed(seed);
            renderer->draw(tile, image, rays);
            return pixel_count(tile);
        };
    };
}

// The smallest tiles with enough paths for a batch.
int tile_side(int samples_per_pixel) {
    int side = 16;
    while (static_cast<std::size_t>(side * side) * static_cast<std::size_t>(samples_per_pixel) <
           batch_size)
        side *= 2;
    return side;
}

}  // namespace
}  // namespace batches

effects::TileRenderer effects::make_batched(const rt::SceneDescription& scene, int width,
                                            int height, const rt::Quality& quality) {
    const rt::Effects needed = rt::needed_effects(scene);
    if (!covers(rt::batch_effects, needed))
        return make_narrowest(needed, scene, width, height, quality);
    return {{rt::batch_effects, without(rt::every_effect, rt::batch_effects), 1, true},
            batches::make_workers(scene, width, height, quality),
            batches::tile_side(quality.samples_per_pixel)};
}
