// Chapter 14: the Cornell box, lit by a lamp of two triangles.
//
// To read in five minutes: make_cornell() in scene.hpp says what is in the picture, and render()
// below draws it, tile by tile, as in chapter 12. What is new is MeshLights, the lamps of a scene
// with meshes that shine.

#include <algorithm>
#include <app/errors.hpp>
#include <app/run.hpp>
#include <rt/draw_by_tiles.hpp>
#include <rt/false_colors.hpp>
#include <rt/renderer.hpp>
#include <rt/show_description.hpp>
#include <string>
#include <thread>
#include <utility>

#include "plates.hpp"
#include "scene.hpp"
#include "streets.hpp"
#include "sun.hpp"

namespace {

using namespace light;

// The view that was asked for, or else the one that suits the scene.
View view_of(const app::Settings& settings, const View& usual) {
    for (const char* const option : {"from", "at", "fov"})
        if (settings.given.count(option) > 0) return *settings.view;
    return usual;
}

Ways ways_of(const std::string& word) {
    if (word == "samples") return Ways::samples;
    if (word == "bounces") return Ways::bounces;
    return word == "balance" ? Ways::balance : Ways::power;
}

// A scene with lamps of this type.
template <class Lamps>
app::Picture draw_lit(Scene scene, Ways ways, const app::Settings& settings,
                      app::Progress& progress) {
    using Ready = LitMeshScene<scene_effects, Lamps>;
    const int width = settings.width, height = settings.height;
    if (!settings.show.empty())
        return show_ready(Ready{scene.description, width, height, std::move(scene.meshes), ways},
                          settings, progress);
    return draw_with(
        Renderer<scene_effects, Ready>{scene.description, width, height,
                                       Quality{settings.spp, settings.depth, *settings.seed},
                                       std::move(scene.meshes), ways},
        settings, progress);
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const std::string& scene = settings.choice("scene");
    const int width = settings.width, height = settings.height;
    if (scene == "points") {
        if (!settings.show.empty()) throw app::UsageError("--scene points: leave out --show");
        return {make_points(width, height)};
    }
    const Quality quality{settings.spp, settings.depth, *settings.seed};
    const Ways ways = ways_of(settings.choice("ways"));
    if (scene == "plates") {
        SceneDescription description;
        description.camera.view = view_of(settings, plates_view());
        if (!settings.show.empty())
            return show_ready(PlatesScene{description, width, height, ways}, settings, progress);
        return draw_with(
            Renderer<scene_effects, PlatesScene>{description, width, height, quality, ways},
            settings, progress);
    }
    if (scene == "sun") {
        const SceneDescription description = make_sun(view_of(settings, sun_view()));
        using Ready = SkyScene<scene_effects>;
        if (!settings.show.empty())
            return show_ready(Ready{description, width, height, SceneMeshes{}, ways}, settings,
                              progress);
        return draw_with(Renderer<scene_effects, Ready>{description, width, height, quality,
                                                        SceneMeshes{}, ways},
                         settings, progress);
    }
    if (scene == "streets") {
        if (settings.choice("lamps") == "list")
            return draw_lit<MeshLights>(make_streets(view_of(settings, streets_view())), ways,
                                        settings, progress);
        return draw_lit<TreeLights>(make_streets(view_of(settings, streets_view())), ways, settings,
                                    progress);
    }
    return draw_lit<MeshLights>(
        scene == "party" ? make_party(*settings.view) : make_cornell(*settings.view), ways,
        settings, progress);
}

}  // namespace

int main(int argc, char** argv) {
    app::Settings defaults;
    defaults.width = 600;
    defaults.height = 600;
    defaults.spp = 64;
    defaults.depth = 16;
    defaults.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    defaults.seed = 1;
    defaults.exposure = 0;
    defaults.view = cornell_view();
    return app::run(
        argc, argv,
        {.name = "14_light",
         .about = "the Cornell box, lit by a lamp of two triangles",
         .defaults = defaults,
         .render = render,
         .study = app::program_study,
         .choices =
             {{"scene",
               "What to draw: the Cornell box, the same box with 90 small lamps (party), "
               "plates that mirror lamps, balls under a sky with a small sun, a town with 10,000 "
               "lamps (streets), or points spread over a triangle",
               {"cornell", "party", "plates", "sun", "streets", "points"}},
              {"lamps",
               "How --scene streets chooses among its lamps: by a tree, near ones more often, or "
               "by their power alone (list)",
               {"tree", "list"}},
              {"ways",
               "How lamps are found: by samples of them, by bounces that meet them, or by "
               "both, weighted by the balance heuristic or the power heuristic",
               {"power", "balance", "samples", "bounces"}}},
         .shows = shown_of_paths(),
         .can_be_stopped = true});
}
