// Chapter 08: a scene file, or the course's final scene, drawn by the narrowest renderer that has
// all the effects that it needs.
//
// To read in five minutes: final_scene() at the end of scene_files/final_scene.cpp says what is in
// the picture, the camera first. render() below chooses a renderer and shares out the picture's
// tiles. Renderer in renderer/rt/renderer.hpp averages the paths of each pixel.

#include <app/run.hpp>
#include <rt/choose_renderer.hpp>
#include <rt/false_colors.hpp>

#include "open_scene.hpp"
#include "pixel_renderer.hpp"
#include "shown_scene.hpp"
#include "words.hpp"

namespace {

using namespace rt;

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const SceneDescription scene = effects::open_scene(settings);
    if (!settings.show.empty()) return effects::show_scene(scene, settings, progress);

    const auto& [width, height, samples, depth, seed] = scene.settings;
    const Effects needed = needed_effects(scene);
    const auto [choice, color] =
        effects::make_narrowest(needed, scene, width, height, {samples, depth, seed});
    if (settings.explain)
        settings.explain(
            effects::explanation(effects::name_of(scene, settings.file), needed, choice));

    app::Picture picture = draw_by_tiles(
        {width, height, 16}, settings.threads, progress,
        [draw = pixel_by_pixel(color)](const Tile& tile, int /*worker*/, Image& image,
                                       std::uint64_t& rays) { return draw(tile, image, rays); });
    picture.words = [note = effects::note_on(scene)] { return note; };
    return picture;
}

}  // namespace

int main(int argc, char** argv) {
    return app::run(argc, argv,
                    {.name = "08_effects",
                     .about = "a scene, drawn by the narrowest renderer that has its effects",
                     .defaults = effects::default_settings(),
                     .render = render,
                     .study = app::program_study,
                     .shows = shown_of_paths(),
                     .reads = "The scene file, .json; without it the final scene is drawn",
                     .others = "./course run 08 also takes the options of later chapters",
                     .explains = true,
                     .can_be_stopped = true});
}
