// Chapter 10: a hundred thousand spheres, drawn in batches of paths that make each bounce together.

#include <app/run.hpp>
#include <optional>
#include <rt/batch_renderer.hpp>
#include <rt/draw_by_tiles.hpp>
#include <rt/show_description.hpp>
#include <thread>

#include "scene.hpp"

namespace {

using namespace batches;

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const SceneDescription description = make_scene(100'000, *settings.view);
    if (!settings.show.empty())
        return show_description<scene_effects>(description, settings, progress);
    const ReadyScene<scene_effects> scene{description, settings.width, settings.height};
    const Quality quality{settings.spp, settings.depth, *settings.seed};

    // Each worker has a renderer of its own, which keeps its memory from tile to tile.
    std::vector<std::optional<BatchRenderer<scene_effects>>> renderers(
        static_cast<std::size_t>(settings.threads));
    return draw_by_tiles({settings.width, settings.height, 32}, settings.threads, progress,
                         [&](const Tile& tile, int worker, Image& image, std::uint64_t& rays) {
                             auto& mine = renderers[static_cast<std::size_t>(worker)];
                             if (!mine) mine.emplace(scene, quality);
                             mine->draw(tile, image, rays);
                             return pixel_count(tile);
                         });
}

}  // namespace

int main(int argc, char** argv) {
    app::Settings defaults;
    defaults.spp = 36;
    defaults.depth = 16;
    defaults.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    defaults.seed = 1;
    defaults.exposure = 0;
    defaults.view = scene_view();
    return app::run(argc, argv,
                    {.name = "10_batches",
                     .about = "a hundred thousand spheres, drawn in batches of paths",
                     .defaults = defaults,
                     .render = render,
                     .study = app::program_study,
                     .shows = shown_of_paths(),
                     .can_be_stopped = true});
}
