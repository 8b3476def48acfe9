// The renderers that follow each path to its end, of scenes that may have meshes.

#include <memory>
#include <rt/choose_renderer.hpp>
#include <rt/renderer.hpp>
#include <rt/show_description.hpp>

#include "few_effects.hpp"
#include "shown_scene.hpp"
#include "tile_workers.hpp"

namespace full_renderer {
namespace {

using namespace rt;

template <Effects effects>
DrawTile make_meshed(const MeshedDescription& scene, int width, int height,
                     const Quality& quality) {
    return pixel_by_pixel(std::make_shared<const Renderer<effects, MeshScene<effects>>>(
        scene, width, height, quality, meshes_of(scene)));
}

constexpr auto makers = for_few_effects([]<Effects effects> { return &make_meshed<effects>; });

}  // namespace

TileWorkers make_path_by_path(const MeshedDescription& scene, int width, int height,
                              const Quality& quality) {
    const Effects needed = needed_effects(scene);
    if (scene.meshes.empty()) {
        const effects::TileRenderer renderer =
            effects::make_narrowest(needed, scene, width, height, quality);
        return {renderer.choice, [draw = renderer.draw] { return draw; }};
    }
    const std::size_t number = narrowest(needed, few_effects);
    const DrawTile draw = makers[number](scene, width, height, quality);
    return {effects::choice_of(few_effects, number), [draw] { return draw; }};
}

app::Picture show_scene(const MeshedDescription& scene, const app::Settings& settings,
                        app::Progress& progress) {
    if (scene.meshes.empty()) return effects::show_scene(scene, settings, progress);
    MeshedDescription still = scene;
    hold_still(still.camera, settings.show);
    return show_ready(MeshScene<every_effect>{still, scene.settings.width, scene.settings.height,
                                              meshes_of(still)},
                      effects::with_settings_of(scene, settings), progress);
}

}  // namespace full_renderer
