// All renderers are compiled here, once, because that takes long.

#include <app/run.hpp>
#include <cassert>
#include <rt/choose_renderer.hpp>
#include <rt/for_each_pixel.hpp>
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
        std::int64_t done = 0;
        for_each_pixel(tile, [&](int x, int y) {
            if (app::Interruption::signal() != 0) return;
            image.at(x, y) = shade(x, y, seed, rays);
            assert(is_finite(image.at(x, y)));
            ++done;
        });
        return done;
    };
    const Effects chosen = renderer_effects[number];
    return {{chosen, without(every_effect, chosen), renderer_effects.size()},
            [draw] { return DrawTile{draw}; }};
}

}  // namespace effects
