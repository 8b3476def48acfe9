// What chapter 08's program draws with if --batches is given. It is linked into that program.

#include <array>
#include <memory>
#include <rt/batch_renderer.hpp>
#include <rt/choose_renderer.hpp>
#include <rt/needed_effects.hpp>
#include <utility>

#include "few_effects.hpp"
#include "tile_renderer.hpp"

namespace batches {
namespace {

using namespace rt;
using effects::DrawTile;

// A batch asks which kernel it needs once, not once per ray, so an effect that is compiled
// in but not used costs little. What does cost time is leaving the kernels for packs,
// which the last two sets do.
using effects::few_effects;

template <Effects effects>
std::function<DrawTile()> make_workers(const SceneDescription& description, int width, int height,
                                       const Quality& quality) {
    const auto scene = std::make_shared<const ReadyScene<effects>>(description, width, height);
    return [scene, quality] {
        const auto renderer = std::make_shared<BatchRenderer<effects>>(*scene, quality);
        return [scene, renderer](const Tile& tile, std::uint64_t seed, Image& image,
                                 std::uint64_t& rays) {
            renderer->set_seed(seed);
            renderer->draw(tile, image, rays);
            return pixel_count(tile);
        };
    };
}

constexpr auto makers = []<std::size_t... number>(std::index_sequence<number...>) {
    return std::array{make_workers<few_effects[number]>...};
}
(std::make_index_sequence<few_effects.size()>{});

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
    const std::size_t number = rt::narrowest(rt::needed_effects(scene), few_effects);
    const rt::Effects chosen = few_effects[number];
    return {{chosen, without(few_effects.back(), chosen), few_effects.size()},
            batches::makers[number](scene, width, height, quality),
            batches::tile_side(quality.samples_per_pixel)};
}
