// Chapter 12: a teapot on a stormy sea of a million triangles.
//
// To read in five minutes: make_scene() at the end of scene.hpp says what is in the picture, and
// render() below draws it, tile by tile. A path is followed as in chapter 08. What is new is the
// tree of triangles beside the tree of spheres, and MeshMaterials, which scatters light with smooth
// normals.

#include <algorithm>
#include <app/run.hpp>
#include <rt/draw_by_tiles.hpp>
#include <rt/mesh_scene.hpp>
#include <rt/renderer.hpp>
#include <rt/show_description.hpp>
#include <thread>
#include <utility>

#include "scene.hpp"

namespace {

using namespace triangles;

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    // About three triangles a pixel: a small picture needs no finer sea.
    const std::int64_t pixels = std::int64_t{settings.width} * settings.height;
    const auto count = static_cast<int>(std::clamp<std::int64_t>(3 * pixels, 100'000, 1'000'000));
    Scene made = make_scene(count, *settings.view);
    const int width = settings.width, height = settings.height;
    if (!settings.show.empty())
        return show_ready(
            MeshScene<scene_effects>{made.description, width, height, std::move(made.meshes)},
            settings, progress);
    const Renderer<scene_effects, MeshScene<scene_effects>> renderer{
        made.description,
        width,
        height,
        {settings.spp, settings.depth, *settings.seed},
        std::move(made.meshes)};
    return draw_by_tiles({width, height, 16}, settings.threads, progress,
                         [&](const Tile& tile, int, Image& image, std::uint64_t& rays) {
                             return draw_pixels(tile, image,
                                                [&](int x, int y) { return renderer(x, y, rays); });
                         });
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
                     .study = app::program_study,
                     .shows = shown_of_paths(),
                     .can_be_stopped = true});
}
