// Chapter 08: a scene file, or the course's final scene, drawn by the narrowest renderer that has
// all the effects that it needs.

#include <algorithm>
#include <app/errors.hpp>
#include <app/limits.hpp>
#include <app/run.hpp>
#include <atomic>
#include <rt/canvas.hpp>
#include <rt/effects_of.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/render_tiles.hpp>
#include <thread>

#include "final_scene.hpp"
#include "narrowest_renderer.hpp"
#include "scene_file.hpp"
#include "study.hpp"
#include "tile_drawing.hpp"

namespace {

using namespace rt;

// The scene that the person asked for, with the settings from the command line.
SceneDescription open_scene(const app::Settings& settings) {
    SceneDescription scene =
        settings.file.empty() ? effects::final_scene() : effects::read_scene(settings.file);
    RenderSettings& chosen = scene.settings;
    const auto given = [&](const char* option) { return settings.given.count(option) > 0; };
    if (given("width")) chosen.width = settings.width;
    if (given("height")) chosen.height = settings.height;
    if (given("spp")) chosen.samples_per_pixel = settings.spp;
    if (given("depth")) chosen.depth = settings.depth;
    if (given("seed")) chosen.seed = *settings.seed;
    // One side may be the file's, and the other the command line's.
    if (std::int64_t{chosen.width} * chosen.height > app::most_pixels)
        throw app::UsageError(std::to_string(chosen.width) + "x" + std::to_string(chosen.height) +
                              " are more than " + std::to_string(app::most_pixels) +
                              " pixels; make --width or --height smaller");
    return scene;
}

std::string explanation(const SceneDescription& scene, const std::string& file,
                        const effects::Choice& choice, bool in_batches) {
    const Effects needed = effects_of(scene);
    const std::size_t spheres = scene.spheres.size();
    return "scene:    " + (file.empty() ? "the final scene" : file) + ", " +
           std::to_string(spheres) + (spheres == 1 ? " sphere" : " spheres") +
           "\nneeds:    " + names(needed) + "\nrenderer: " + names(choice.chosen) + ", one of " +
           std::to_string(choice.renderers) + (in_batches ? " for batches" : "") +
           "\nunused:   " + names(without(choice.chosen, needed)) +
           "\nleft out: " + names(choice.left_out) + '\n';
}

// What the person may have overlooked; "" if nothing.
std::string note_on(const SceneDescription& scene) {
    const auto moves = [](const SphereDescription& sphere) { return sphere.velocity != Vec3{}; };
    const auto count = std::count_if(scene.spheres.begin(), scene.spheres.end(), moves);
    if (count == 0 || scene.camera.shutter > 0) return "";
    return "note: " + std::to_string(count) + (count == 1 ? " sphere has" : " spheres have") +
           " a velocity and no trail, because camera.shutter is 0\n";
}

// The usual way: pixel by pixel, each path to its end.
effects::TileDrawing one_by_one(const SceneDescription& scene, int width, int height,
                                const Quality& quality) {
    const Effects needed = effects_of(scene);
    const effects::Shader shade = effects::make_narrowest(needed, scene, width, height, quality);
    const auto draw = [shade](const Tile& tile, Image& image, std::uint64_t& rays) {
        std::int64_t done = 0;
        for_each_pixel(tile, [&](int x, int y) {
            if (app::Interruption::signal() != 0) return;
            image.at(x, y) = shade(x, y, rays);
            assert(is_finite(image.at(x, y)));
            ++done;
        });
        return done;
    };
    return {effects::choose(needed), [draw] { return effects::DrawTile{draw}; }};
}

bool in_batches(const app::Settings& settings) {
    return settings.given.count("batches") > 0;
}
bool by_sobol(const app::Settings& settings) {
    return !settings.picked.empty() && settings.picked.front() == "sobol";
}

// The way to draw that the options ask for.
effects::TileDrawing make_drawing(const SceneDescription& scene, const app::Settings& settings) {
    const RenderSettings& chosen = scene.settings;
    const Quality quality{chosen.samples_per_pixel, chosen.depth, chosen.seed};
    if (!by_sobol(settings) && !in_batches(settings))
        return one_by_one(scene, chosen.width, chosen.height, quality);
    const auto make =
        by_sobol(settings) ? effects::refining->make_sobol_drawing : effects::make_batch_drawing;
    return with_seed(make(scene, chosen.width, chosen.height, quality), quality.seed);
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const SceneDescription scene = open_scene(settings);
    const RenderSettings& chosen = scene.settings;
    if (by_sobol(settings) && in_batches(settings))
        throw app::UsageError(
            "--batches and --sampler sobol exclude each other: batches are drawn with jittered "
            "samples");
    const auto explain = [&](const effects::Choice& choice) {
        if (settings.explain)
            settings.explain(explanation(scene, settings.file, choice, in_batches(settings)));
    };
    if (!settings.numbers.empty()) {
        app::Picture picture = effects::refining->render(scene, settings, explain, progress);
        picture.words = [words = picture.words, note = note_on(scene)] { return words() + note; };
        return picture;
    }
    const effects::TileDrawing drawing = make_drawing(scene, settings);
    explain(drawing.choice);

    Image image = Canvas<Color>{chosen.width, chosen.height};
    app::draw_unfinished(image);
    std::atomic<std::uint64_t> all_rays = 0;
    std::atomic<std::int64_t> pixels_done = 0;
    const app::Interruption interruption;
    const TileGrid grid{chosen.width, chosen.height, drawing.tile_side};
    progress.start(tile_count(grid));
    std::vector<effects::DrawTile> workers(static_cast<std::size_t>(settings.threads));
    render_tiles(grid, settings.threads, [&](const Tile& tile, int worker) {
        effects::DrawTile& draw = workers[static_cast<std::size_t>(worker)];
        if (!draw) draw = drawing.make_worker();
        std::uint64_t rays = 0;
        pixels_done += draw(tile, image, rays);
        all_rays += rays;
        progress.step();
    });
    app::Picture picture{std::move(image), all_rays};
    picture.words = [note = note_on(scene)] { return note; };
    if (const int signal = interruption.signal()) {
        const auto all = static_cast<double>(picture.image.pixels().size());
        picture.stopped = {signal, static_cast<double>(pixels_done) / all};
    }
    return picture;
}

}  // namespace

int main(int argc, char** argv) {
    // What a scene file says; the final scene says the same.
    const RenderSettings usual;
    app::Settings defaults;
    defaults.width = usual.width;
    defaults.height = usual.height;
    defaults.spp = usual.samples_per_pixel;
    defaults.depth = usual.depth;
    defaults.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    defaults.seed = usual.seed;
    std::vector<app::Flag> flags;
    if (effects::make_batch_drawing)
        flags = {{"batches", "Draw the same picture in batches of rays, as chapter 10 does"}};
    const effects::Refining refining = effects::refining ? *effects::refining : effects::Refining{};
    return app::run(argc, argv,
                    {.name = "08_effects",
                     .about = "a scene, drawn by a renderer that has its effects and no others",
                     .defaults = defaults,
                     .render = render,
                     .study = effects::run_study,
                     .choices = refining.choices,
                     .flags = flags,
                     .numbers = refining.numbers,
                     .reads = "The scene file, .json; without it the final scene is drawn",
                     .explains = true,
                     .can_be_stopped = true});
}
