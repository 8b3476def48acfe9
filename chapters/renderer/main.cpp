// The program with all options: scenes of chapter 08, path by path as there, in the batches of
// chapter 10, with the samples of chapter 11, and with the meshes of chapter 12.
//
// ./course run 08 takes it when the options or the scene need it. tile_workers.hpp lists its ways
// to draw.

#include <app/errors.hpp>
#include <app/run.hpp>
#include <rt/choose_renderer.hpp>
#include <rt/counted.hpp>
#include <rt/false_colors.hpp>

#include "open_meshed.hpp"
#include "open_scene.hpp"
#include "tile_workers.hpp"
#include "words.hpp"

namespace {

using namespace rt;
using namespace full_renderer;

bool in_batches(const app::Settings& settings) {
    return settings.given.count("batches") > 0;
}
bool by_sobol(const app::Settings& settings) {
    return settings.choice("sampler") == "sobol";
}
bool by_tent(const app::Settings& settings) {
    return settings.choice("filter") == "tent";
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

// What draws the scene as the options ask for it.
TileWorkers make_workers(const MeshedDescription& scene, const app::Settings& settings) {
    const auto& [width, height, samples, depth, seed] = scene.settings;
    const Quality quality{samples, depth, seed};
    const bool batches = in_batches(settings);
    if (by_tent(settings)) return make_tent(scene, width, height, quality, batches);
    if (by_sobol(settings)) return make_sobol(scene, width, height, quality, batches);
    if (batches) return make_batched(scene, width, height, quality);
    return make_path_by_path(scene, width, height, quality);
}

// The picture, tile by tile, each thread with a worker of its own.
app::Picture draw(const TileWorkers& drawing, const RenderSettings& chosen, int threads,
                  app::Progress& progress) {
    std::vector<DrawTile> workers(static_cast<std::size_t>(threads));
    return draw_by_tiles({chosen.width, chosen.height, drawing.tile_side}, threads, progress,
                         [&](const Tile& tile, int worker, Image& image, std::uint64_t& rays) {
                             DrawTile& draw_tile = workers[static_cast<std::size_t>(worker)];
                             if (!draw_tile) draw_tile = drawing.make_worker();
                             return draw_tile(tile, image, rays);
                         });
}

std::string name_of(const MeshedDescription& scene, const std::string& file) {
    std::size_t triangles = 0;
    for (const MeshDescription& mesh : scene.meshes) triangles += mesh.mesh->triangles.size();
    return effects::name_of(scene, file) +
           (triangles > 0 ? ", " + counted(triangles, "triangle") : "");
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const Say say = [&](const std::string& what) { progress.say(what); };
    const MeshedDescription scene = full_renderer::open_scene(settings, say);
    if (!scene.meshes.empty()) say("building the trees of the meshes");
    check_together(settings);
    const bool refines = !settings.numbers.empty();
    const auto explain = [&](const Choice& choice) {
        if (settings.explain)
            settings.explain(
                effects::explanation(name_of(scene, settings.file), needed_effects(scene), choice));
    };
    if (!settings.show.empty() && !(refines && settings.show == "samples"))
        return show_scene(scene, settings, progress);
    app::Picture picture;
    if (refines) {
        picture = refine(scene, settings, explain, progress);
    } else {
        const TileWorkers drawing = make_workers(scene, settings);
        explain(drawing.choice);
        picture = draw(drawing, scene.settings, settings.threads, progress);
    }
    std::string note = effects::note_on(scene);
    for (const std::string& line : scene.notes) note += "note: " + line + '\n';
    picture.words = [words = picture.words, note] { return words ? words() + note : note; };
    return picture;
}

}  // namespace

int main(int argc, char** argv) {
    return app::run(
        argc, argv,
        {.name = "renderer",
         .about = "a scene, drawn by the narrowest renderer that has its effects",
         .defaults = effects::default_settings(),
         .render = render,
         .study = nullptr,
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
