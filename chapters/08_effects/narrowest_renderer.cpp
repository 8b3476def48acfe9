// All renderers are compiled here, once, because that takes long.

#include <rt/choose_renderer.hpp>
#include <rt/draw_by_tiles.hpp>
#include <rt/renderers.hpp>

#include "tile_renderer.hpp"

namespace effects {

using namespace rt;

TileRenderer make_narrowest(const Effects& needed, const SceneDescription& scene, int width,
                            int height, const Quality& quality) {
    const std::size_t number = narrowest(needed, renderer_effects);
    const PixelShader shade = renderer_makers[number](scene, width, height, quality);
    const auto draw = [shade](const Tile& tile, std::uint64_t seed, Image& image,
                              std::uint64_t& rays) {
        return draw_pixels(tile, image, [&](int x, int y) { return shade(x, y, seed, rays); });
    };
    return {choice_of(renderer_effects, number), [draw] { return DrawTile{draw}; }};
}

}  // namespace effects
