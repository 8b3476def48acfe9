// Chapter 08: a scene file, or the course's final scene, drawn by the narrowest renderer that has
// all the effects that it needs.
//
// To read in five minutes: final_scene() at the end of final_scene.cpp says what is in the picture,
// the camera first. draw() below gives each thread a worker, and draw_by_tiles() shares out the
// picture's tiles. Renderer in rt/renderer.hpp averages the paths of each pixel.

#include <algorithm>
#include <app/errors.hpp>
#include <app/run.hpp>
#include <rt/draw_by_tiles.hpp>
#include <rt/false_colors.hpp>
#include <thread>

#include "open_scene.hpp"
#include "show_scene.hpp"
#include "tile_renderer.hpp"
#include "words.hpp"

namespace {

using namespace rt;

bool in_batches(const app::Settings& settings) {
    return settings.given.count("batches") > 0;
}
bool by_sobol(const app::Settings& settings) {
    return !settings.picked.empty() && settings.picked.front() == "sobol";
}
bool by_tent(const app::Settings& settings) {
    return !settings.picked.empty() && settings.picked.back() == "tent";
}

void check_together(const app::Settings& settings) {
    if (!by_tent(settings)) return;
    for (const char* const other : {"target-error", "time-budget"})
        if (settings.given.count(other) > 0)
            throw app::UsageError("--filter tent and --" + std::string{other} +
                                  " exclude each other: only a picture with --spp is filtered");
    if (settings.given.count("sampler") > 0 && !by_sobol(settings))
        throw app::UsageError(
            "--filter tent and --sampler jittered exclude each other: the tent takes Sobol's "
            "points");
}

// The renderer that the options ask for.
effects::TileRenderer make_renderer(const SceneDescription& scene, const app::Settings& settings) {
    const auto& [width, height, samples, depth, seed] = scene.settings;
    const Quality quality{samples, depth, seed};
    const bool batches = in_batches(settings);
    if (by_tent(settings)) return effects::make_tent(scene, width, height, quality, batches);
    if (by_sobol(settings)) return effects::make_sobol(scene, width, height, quality, batches);
    if (batches) return effects::make_batched(scene, width, height, quality);
    return effects::make_path_by_path(scene, width, height, quality);
}

// The picture, tile by tile, each thread with a worker of its own.
app::Picture draw(const effects::TileRenderer& renderer, const RenderSettings& chosen, int threads,
                  app::Progress& progress) {
    std::vector<effects::DrawTile> workers(static_cast<std::size_t>(threads));
    return draw_by_tiles({chosen.width, chosen.height, renderer.tile_side}, threads, progress,
                         [&](const Tile& tile, int worker, Image& image, std::uint64_t& rays) {
                             effects::DrawTile& draw_tile =
                                 workers[static_cast<std::size_t>(worker)];
                             if (!draw_tile) draw_tile = renderer.make_worker();
                             return draw_tile(tile, chosen.seed, image, rays);
                         });
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const SceneDescription scene = effects::open_scene(settings);
    check_together(settings);
    const bool refines = !settings.numbers.empty();
    const auto explain = [&](const effects::Choice& choice) {
        if (settings.explain) settings.explain(effects::explanation(scene, settings.file, choice));
    };
    if (!settings.show.empty() && !(refines && settings.show == "samples"))
        return effects::show_scene(scene, settings, progress);
    app::Picture picture;
    if (refines) {
        picture = effects::refine(scene, settings, explain, progress);
    } else {
        const effects::TileRenderer renderer = make_renderer(scene, settings);
        explain(renderer.choice);
        picture = draw(renderer, scene.settings, settings.threads, progress);
    }
    picture.words = [words = picture.words, note = effects::note_on(scene)] {
        return words ? words() + note : note;
    };
    return picture;
}

}  // namespace

int main(int argc, char** argv) {
    // The defaults of a scene file, which are also those of the final scene.
    const RenderSettings usual;
    app::Settings defaults;
    defaults.width = usual.width;
    defaults.height = usual.height;
    defaults.spp = usual.samples_per_pixel;
    defaults.depth = usual.depth;
    defaults.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    defaults.seed = usual.seed;
    return app::run(
        argc, argv,
        {.name = "08_effects",
         .about = "a scene, drawn by a renderer that has its effects and no others",
         .defaults = defaults,
         .render = render,
         .study = app::program_study,
         .choices =
             {{"sampler",
               "Where the samples lie, and which random numbers they use; refining takes sobol "
               "unless told otherwise",
               {"jittered", "sobol"}},
              {"filter",
               "Which samples a pixel is made of: its own (box), or also those of its neighbors, "
               "which count less, the farther away they are (tent)",
               {"box", "tent"}}},
         .flags = {{"batches", "Draw the same picture in batches of rays, as chapter 10 does"}},
         .numbers =
             {{"target-error",
               "Refine until the root mean square error is estimated to be below this (white is "
               "1)"},
              {"time-budget",
               "Refine for this many seconds, and draw the best picture possible in that time"}},
         .shows = rt::shown_of_paths(),
         .reads = "The scene file, .json; without it the final scene is drawn",
         .explains = true,
         .can_be_stopped = true});
}
