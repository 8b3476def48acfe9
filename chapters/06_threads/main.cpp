// Chapter 06: one scene, rendered by all cores. The figure shows which worker rendered what, how
// long each worker waited for the others, and the speed-up. The speed-up is also measured and
// printed.

#include <app/run.hpp>
#include <app/threads.hpp>
#include <atomic>
#include <rt/canvas.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/panel.hpp>
#include <rt/show_paths.hpp>
#include <string>
#include <thread>

#include "scene.hpp"
#include "schedule.hpp"
#include "speed_up.hpp"
#include "work_figure.hpp"

namespace {

using namespace threads;

constexpr int tile_size = 16, shown_workers = 6, most_workers = 16;

std::vector<Curve> no_speed_ups() {
    return {{{}, "Slices", slices_color, {0, 11}}, {{}, "Tiles", tiles_color, {-30, -3}}};
}

// The schedules if time is counted in rays: they are the same on every machine.
Schedules count_rays(const RayCounts& rays, const TileGrid& grid) {
    Schedules all{slices_by_rays(rays, grid, shown_workers),
                  tiles_by_rays(rays, grid, shown_workers), no_speed_ups(), "rays"};
    const double alone = slices_by_rays(rays, grid, 1).end();
    for (int workers = 1; workers <= most_workers; ++workers) {
        all.curves[0].speed_up.push_back(alone / slices_by_rays(rays, grid, workers).end());
        all.curves[1].speed_up.push_back(alone / tiles_by_rays(rays, grid, workers).end());
    }
    return all;
}

// The schedules measured by this machine's clock, with this number of workers.
Schedules take_time(const SceneShader& shader, const TileGrid& grid, int workers) {
    Schedules all{by_seconds(render_slices, grid, workers, shader),
                  by_seconds(render_tiles, grid, workers, shader), no_speed_ups(), "seconds"};
    for (const SpeedUp& row : speed_ups(shader.scene, workers)) {
        if (row.strategy != "slices" && row.strategy != "tiles") continue;
        auto& speed_up = all.curves[row.strategy == "tiles"].speed_up;
        speed_up.resize(static_cast<std::size_t>(workers));
        speed_up[static_cast<std::size_t>(row.workers - 1)] = row.times;
    }
    return all;
}

// The measured speed-ups, or why there are none. OpenMP and TBB both keep the threads that they
// have started, and neither works if it cannot start all that it needs.
std::string speed_up_words(int threads) {
    const int needed = 2 * threads + static_cast<int>(std::thread::hardware_concurrency());
    if (app::threads_that_start(needed) < needed)
        return "No speed-up was measured: fewer than " + std::to_string(needed) +
               " threads can be started.\n";
    return table(speed_ups(make_scene(), threads));
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const Scene scene = make_scene();
    if (!settings.show.empty())
        return show_paths(settings, progress, scene.world, scene.materials, scene.sky, SkyEnding{},
                          render_tiles);

    Image image = Canvas<Color>{settings.width, settings.height, paper};
    app::Figure figure{image, figure_width, figure_height};
    const app::Figure view = figure.part(scene_box);
    const TileGrid grid{view.columns(), view.rows(), tile_size};
    const SceneShader shader{scene, make_camera(*settings.view, grid.width, grid.height),
                             settings.spp, settings.depth, *settings.seed};

    // Each worker writes only to the pixels of its own tiles.
    Image picture{grid.width, grid.height};
    std::vector<std::uint32_t> rays(picture.pixels().size());
    std::atomic<std::uint64_t> all_rays = 0;
    progress.start(tile_count(grid));
    app::begin_panel(view);
    render_tiles(grid, settings.threads, [&](const Tile& tile, int) {
        std::uint64_t tile_rays = 0;
        for_each_pixel(tile, [&](int x, int y) {
            const ScenePixel pixel = shader(x, y);
            picture.at(x, y) = pixel.color;
            rays[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width) +
                 static_cast<std::size_t>(x)] = static_cast<std::uint32_t>(pixel.rays);
            tile_rays += pixel.rays;
        });
        all_rays += tile_rays;  // once per tile, not once per ray: an atomic is not free
        progress.step();
    });

    const Schedules shown = settings.choice("clock") == "rays"
                                ? count_rays({grid.width, grid.height, rays}, grid)
                                : take_time(shader, grid, settings.threads);
    draw_figure(figure, picture, shown);
    return {std::move(image), all_rays,
            [threads = settings.threads] { return speed_up_words(threads); }};
}

}  // namespace

int main(int argc, char** argv) {
    app::Settings defaults;
    defaults.spp = 49;
    defaults.depth = 12;
    defaults.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    defaults.seed = 1;
    defaults.view = scene_view();
    return app::run(
        argc, argv,
        {.name = "06_threads",
         .about = "a scene rendered by all cores, which worker rendered what, and the speed-up",
         .defaults = defaults,
         .render = render,
         .study = app::program_study,
         .choices = {{"clock",
                      "What the maps, bars and curves count: rays (the same on every machine), or "
                      "seconds of this machine",
                      {"rays", "seconds"}}},
         .shows = rt::shown_of_paths()});
}
