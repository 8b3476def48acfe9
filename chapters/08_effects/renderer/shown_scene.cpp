#include "shown_scene.hpp"

#include <rt/show_description.hpp>

namespace effects {

app::Picture show_scene(const rt::SceneDescription& scene, const app::Settings& settings,
                        app::Progress& progress) {
    return rt::show_description<rt::every_effect>(scene, with_settings_of(scene, settings),
                                                  progress);
}

app::Settings with_settings_of(const rt::SceneDescription& scene, app::Settings settings) {
    settings.width = scene.settings.width;
    settings.height = scene.settings.height;
    settings.spp = scene.settings.samples_per_pixel;
    settings.seed = scene.settings.seed;
    settings.depth = scene.settings.depth;
    return settings;
}

}  // namespace effects
