#include "show_scene.hpp"

#include <rt/show_description.hpp>

#include "tile_renderer.hpp"

app::Picture effects::show_scene(const rt::SceneDescription& scene, app::Settings settings,
                                 app::Progress& progress) {
    settings.width = scene.settings.width;
    settings.height = scene.settings.height;
    settings.spp = scene.settings.samples_per_pixel;
    settings.seed = scene.settings.seed;
    settings.depth = scene.settings.depth;
    if (!scene.meshes.empty()) return show_meshed(scene, settings, progress);
    return rt::show_description<rt::every_effect>(scene, settings, progress);
}
