// Chapter 12: a teapot on a stormy sea of a million triangles.
//
// To read in five minutes: make_scene() at the end of scene.hpp says what is in the picture, and
// render() below draws it, tile by tile. A path is followed as in chapter 08. What is new is the
// tree of triangles beside that of spheres, and MeshMaterials, which scatter light by smooth
// normals.

#include <algorithm>
#include <app/run.hpp>
#include <atomic>
#include <rt/canvas.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/mesh_renderer.hpp>
#include <rt/render_tiles.hpp>
#include <rt/show_paths.hpp>
#include <thread>

#include "scene.hpp"
#include "study.hpp"

namespace {

using namespace triangles;

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    // About three triangles a pixel: a small picture needs no finer sea.
    const std::int64_t pixels = std::int64_t{settings.width} * settings.height;
    const auto count = static_cast<int>(std::clamp<std::int64_t>(3 * pixels, 100'000, 1'000'000));
    Scene made = make_scene(count, *settings.view);
    const MeshScene<scene_effects> scene{made.description, std::move(made.meshes), settings.width,
                                         settings.height};
    if (!settings.show.empty()) {
        const auto path = [&](const auto& ray, const auto& world, Rng& random) {
            return scene.radiance(world, ray, settings.depth, random);
        };
        return show_world(settings, progress, scene.ready.camera, scene.world, path, render_tiles);
    }
    Image image = Canvas<Color>{settings.width, settings.height};
    app::draw_unfinished(image);
    std::atomic<std::uint64_t> all_rays = 0;
    std::atomic<std::int64_t> pixels_done = 0;
    const app::Interruption interruption;
    const TileGrid grid{settings.width, settings.height, 16};
    progress.start(tile_count(grid));
    const JitteredSamples samples{*settings.seed, settings.spp};
    render_tiles(grid, settings.threads, [&](const Tile& tile, int) {
        if (interruption.signal() != 0) return;
        std::uint64_t rays = 0;
        for_each_pixel(tile, [&](int x, int y) {
            image.at(x, y) = scene.pixel(samples, settings.depth, x, y, rays);
        });
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
    defaults.depth = 12;
    defaults.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    defaults.seed = 1;
    defaults.view = scene_view();
    return app::run(argc, argv,
                    {.name = "12_triangles",
                     .about = "a teapot on a stormy sea of a million triangles",
                     .defaults = defaults,
                     .render = render,
                     .study = triangles::run_study,
                     .shows = shown_of_paths(),
                     .can_be_stopped = true});
}
