#include "open_scene.hpp"

#include <algorithm>
#include <app/errors.hpp>
#include <app/limits.hpp>
#include <thread>

#include "final_scene.hpp"
#include "scene_file.hpp"

namespace effects {

app::Settings default_settings() {
    const rt::RenderSettings usual;
    app::Settings defaults;
    defaults.width = usual.width;
    defaults.height = usual.height;
    defaults.spp = usual.samples_per_pixel;
    defaults.depth = usual.depth;
    defaults.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    defaults.seed = usual.seed;
    defaults.exposure = 0;
    return defaults;
}

rt::SceneDescription open_scene(const app::Settings& settings) {
    rt::SceneDescription scene = settings.file.empty() ? final_scene() : read_scene(settings.file);
    replace_by_given(scene.settings, settings);
    return scene;
}

void replace_by_given(rt::RenderSettings& of_scene, const app::Settings& settings) {
    const auto given = [&](const char* option) { return settings.given.count(option) > 0; };
    if (given("width")) of_scene.width = settings.width;
    if (given("height")) of_scene.height = settings.height;
    if (given("spp")) of_scene.samples_per_pixel = settings.spp;
    if (given("depth")) of_scene.depth = settings.depth;
    if (given("seed")) of_scene.seed = *settings.seed;
    // One of width and height may come from the file, and the other from the command line.
    if (std::int64_t{of_scene.width} * of_scene.height > app::most_pixels)
        throw app::UsageError(std::to_string(of_scene.width) + "x" +
                              std::to_string(of_scene.height) + " are more than " +
                              std::to_string(app::most_pixels) +
                              " pixels; make --width or --height smaller");
}

}  // namespace effects
