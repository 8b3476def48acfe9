// Chapter 12: a teapot on a stormy sea of a million triangles.
//
// To read in five minutes: make_scene() in scene.hpp says what is in the picture, and render()
// below draws it, tile by tile. A path is followed as in chapter 08. What is new is the tree of
// triangles beside the tree of spheres, and MeshMaterials, which scatters light with smooth
// normals.

#include <algorithm>
#include <app/errors.hpp>
#include <app/run.hpp>
#include <rt/draw_by_tiles.hpp>
#include <rt/false_colors.hpp>
#include <rt/hit_triangle.hpp>
#include <rt/mesh_scene.hpp>
#include <rt/renderer.hpp>
#include <rt/show_description.hpp>
#include <string>
#include <thread>
#include <utility>

#include "scene.hpp"

namespace {

using namespace triangles;

// One triangle, without a tree: red, green and blue are the weights of its corners.
app::Picture draw_triangle(const app::Settings& settings, app::Progress& progress) {
    if (!settings.show.empty()) throw app::UsageError("--scene triangle: leave out --show");
    const Camera camera = make_camera(*settings.view, settings.width, settings.height);
    return {app::draw(settings, progress, [&](int x, int y) {
        const Ray ray = primary_ray(camera, x, y, {Real(0.5), Real(0.5)});
        const auto hit = hit_triangle(single_triangle, ray, {0, infinity});
        return hit ? Color{1 - hit->u - hit->v, hit->u, hit->v} : nothing_color;
    })};
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const std::string& scene = settings.choice("scene");
    if (scene == "triangle") return draw_triangle(settings, progress);
    // About three triangles a pixel: a small picture needs no finer sea.
    const std::int64_t pixels = std::int64_t{settings.width} * settings.height;
    const auto count = static_cast<int>(std::clamp<std::int64_t>(3 * pixels, 100'000, 1'000'000));
    Scene made = scene == "sea" ? make_scene(count, *settings.view)
                 : scene == "ball" || scene == "sphere"
                     ? make_clay_ball(scene == "ball", *settings.view)
                     : make_pot(scene == "pot", *settings.view);
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
    return draw_with(renderer, settings, progress);
}

}  // namespace

int main(int argc, char** argv) {
    app::Settings defaults;
    defaults.spp = 36;
    defaults.depth = 12;
    defaults.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    defaults.seed = 1;
    defaults.exposure = 0;
    defaults.view = scene_view();
    return app::run(argc, argv,
                    {.name = "12_triangles",
                     .about = "a teapot on a stormy sea of a million triangles",
                     .defaults = defaults,
                     .render = render,
                     .study = app::program_study,
                     .choices = {{"scene",
                                  "What to draw: the teapot at sea, a single triangle, a golden "
                                  "teapot of flat triangles (facets) or with smooth normals (pot), "
                                  "or clay under a lamp: a ball of triangles, or a sphere",
                                  {"sea", "triangle", "facets", "pot", "ball", "sphere"}}},
                     .shows = shown_of_paths(),
                     .can_be_stopped = true});
}
