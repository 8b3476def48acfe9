#include "open_scene.hpp"

#include <app/errors.hpp>
#include <app/limits.hpp>

#include "final_scene.hpp"
#include "scene_file.hpp"
#include "tile_renderer.hpp"

rt::SceneDescription effects::open_scene(const app::Settings& settings) {
    rt::SceneDescription scene =
        settings.file.empty() ? final_scene() : read_scene(settings.file, read_mesh);
    rt::RenderSettings& chosen = scene.settings;
    const auto given = [&](const char* option) { return settings.given.count(option) > 0; };
    if (given("width")) chosen.width = settings.width;
    if (given("height")) chosen.height = settings.height;
    if (given("spp")) chosen.samples_per_pixel = settings.spp;
    if (given("depth")) chosen.depth = settings.depth;
    if (given("seed")) chosen.seed = *settings.seed;
    // One of width and height may come from the file, and the other from the command line.
    if (std::int64_t{chosen.width} * chosen.height > app::most_pixels)
        throw app::UsageError(std::to_string(chosen.width) + "x" + std::to_string(chosen.height) +
                              " are more than " + std::to_string(app::most_pixels) +
                              " pixels; make --width or --height smaller");
    return scene;
}
