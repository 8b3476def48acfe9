// The renderers that follow each path to its end, of scenes that may have meshes.

#include <memory>
#include <rt/choose_renderer.hpp>
#include <rt/renderer.hpp>
#include <rt/show_description.hpp>
#include <span>

#include "few_effects.hpp"
#include "lit_meshes.hpp"
#include "shown_scene.hpp"
#include "tile_workers.hpp"

namespace full_renderer {
namespace {

using namespace rt;

template <Effects effects>
PixelColor make_meshed(const MeshedDescription& scene, int width, int height,
                       const Quality& quality) {
    return color_by(std::make_shared<const Renderer<effects, MeshScene<effects>>>(
        scene, width, height, quality, meshes_of(scene)));
}

constexpr auto makers = for_few_effects([]<Effects effects> { return &make_meshed<effects>; });

}  // namespace

effects::PixelRenderer make_pixel_renderer(const MeshedDescription& scene, int width, int height,
                                           const Quality& quality) {
    const Effects needed = needed_effects(scene);
    if (scene.meshes.empty() && !has_sky_or_rough(scene))
        return effects::make_narrowest(needed, scene, width, height, quality);
    if (has_lamp_meshes(scene) || has_sky_or_rough(scene))
        return {effects::choice_of(std::span{few_effects}.last(1), 0),
                make_lit_meshed(scene, width, height, quality)};
    const std::size_t number = narrowest(needed, few_effects);
    return {effects::choice_of(few_effects, number), makers[number](scene, width, height, quality)};
}

TileWorkers make_path_by_path(const MeshedDescription& scene, int width, int height,
                              const Quality& quality) {
    const auto [choice, color] = make_pixel_renderer(scene, width, height, quality);
    return {choice, [draw = pixel_by_pixel(color)] { return draw; }};
}

app::Picture show_scene(const MeshedDescription& scene, const app::Settings& settings,
                        app::Progress& progress) {
    if (scene.meshes.empty() && !has_sky_or_rough(scene))
        return effects::show_scene(scene, settings, progress);
    MeshedDescription still = scene;
    hold_still(still.camera, settings.show);
    if (has_lamp_meshes(scene) || has_sky_or_rough(scene))
        return show_lit_meshed(still, settings, progress);
    return show_ready(MeshScene<every_effect>{still, scene.settings.width, scene.settings.height,
                                              meshes_of(still)},
                      effects::with_settings_of(scene, settings), progress);
}

}  // namespace full_renderer
