#include "lit_meshes.hpp"

#include <algorithm>
#include <memory>
#include <rt/lit_mesh_scene.hpp>
#include <rt/renderer.hpp>
#include <rt/show_description.hpp>
#include <rt/sky_scene.hpp>

#include "shown_scene.hpp"

namespace full_renderer {

using namespace rt;

bool has_lamp_meshes(const MeshedDescription& scene) {
    bool any = false;
    for_other_shapes(scene, [&](int material) {
        any = any || shines(scene.materials[static_cast<std::size_t>(material)]);
    });
    return any;
}

bool has_sky_or_rough(const MeshedDescription& scene) {
    return scene.sky_image ||
           std::any_of(scene.materials.begin(), scene.materials.end(), [](const auto& material) {
               return std::holds_alternative<RoughDescription>(material);
           });
}

PixelColor make_lit_meshed(const MeshedDescription& scene, int width, int height,
                           const Quality& quality) {
    if (has_sky_or_rough(scene))
        return color_by(std::make_shared<const Renderer<every_effect, SkyScene<every_effect>>>(
            scene, width, height, quality, meshes_of(scene)));
    return color_by(std::make_shared<const Renderer<every_effect, LitMeshScene<every_effect>>>(
        scene, width, height, quality, meshes_of(scene)));
}

app::Picture show_lit_meshed(const MeshedDescription& scene, const app::Settings& settings,
                             app::Progress& progress) {
    if (has_sky_or_rough(scene))
        return show_ready(SkyScene<every_effect>{scene, scene.settings.width, scene.settings.height,
                                                 meshes_of(scene)},
                          effects::with_settings_of(scene, settings), progress);
    return show_ready(LitMeshScene<every_effect>{scene, scene.settings.width, scene.settings.height,
                                                 meshes_of(scene)},
                      effects::with_settings_of(scene, settings), progress);
}

}  // namespace full_renderer
