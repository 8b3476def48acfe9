// Chapter 10: a hundred thousand spheres, drawn in batches of paths that make each bounce together.

#include <app/run.hpp>
#include <atomic>
#include <optional>
#include <rt/batch_renderer.hpp>
#include <rt/canvas.hpp>
#include <rt/render_tiles.hpp>
#include <rt/show_description.hpp>
#include <thread>

#include "scene.hpp"
#include "study.hpp"

namespace {

using namespace batches;

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const SceneDescription description = make_scene(100'000, *settings.view);
    if (!settings.show.empty())
        return show_description<scene_effects>(description, settings, progress);
    const ReadyScene<scene_effects> scene{description, settings.width, settings.height};
    const Quality quality{settings.spp, settings.depth, *settings.seed};

    Image image = Canvas<Color>{settings.width, settings.height};
    app::draw_unfinished(image);
    std::atomic<std::uint64_t> all_rays = 0;
    std::atomic<std::int64_t> pixels_done = 0;
    const app::Interruption interruption;
    const TileGrid grid{settings.width, settings.height, 32};
    progress.start(tile_count(grid));
    // Each worker has batches of its own, and keeps their memory from tile to tile.
    std::vector<std::optional<BatchRenderer<scene_effects>>> renderers(
        static_cast<std::size_t>(settings.threads));
    render_tiles(grid, settings.threads, [&](const Tile& tile, int worker) {
        if (interruption.signal() != 0) return;
        auto& mine = renderers[static_cast<std::size_t>(worker)];
        if (!mine) mine.emplace(scene, quality);
        std::uint64_t rays = 0;
        mine->draw(tile, image, rays);
        all_rays += rays;
        pixels_done += pixel_count(tile);
        progress.step();
    });
    app::Picture picture{std::move(image), all_rays};
    if (const int signal = interruption.signal()) {
        const auto all = static_cast<double>(picture.image.pixels().size());
        picture.stopped = {signal, static_cast<double>(pixels_done) / all};
    }
    return picture;
}

}  // namespace

int main(int argc, char** argv) {
    app::Settings defaults;
    defaults.spp = 36;
    defaults.depth = 16;
    defaults.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    defaults.seed = 1;
    defaults.view = scene_view();
    return app::run(argc, argv,
                    {.name = "10_batches",
                     .about = "a hundred thousand spheres, drawn in batches of paths",
                     .defaults = defaults,
                     .render = render,
                     .study = batches::run_study,
                     .shows = shown_of_paths(),
                     .can_be_stopped = true});
}
