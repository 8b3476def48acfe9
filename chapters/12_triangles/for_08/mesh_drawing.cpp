// The part of chapter 08's program that draws scenes with meshes. This file is linked into that
// program.

#include <memory>
#include <rt/choose_renderer.hpp>
#include <rt/draw_by_tiles.hpp>
#include <rt/mesh_scene.hpp>
#include <rt/needed_effects.hpp>
#include <rt/renderer.hpp>
#include <rt/show_description.hpp>
#include <stdexcept>

#include "few_effects.hpp"
#include "tile_renderer.hpp"

namespace triangles {
namespace {

using namespace rt;
using effects::DrawTile, effects::few_effects;

template <Effects effects>
DrawTile make_drawing(const SceneDescription& description, int width, int height,
                      const Quality& quality) {
    const auto renderer = std::make_shared<const Renderer<effects, MeshScene<effects>>>(
        description, width, height, quality);
    return [renderer, count = quality.samples_per_pixel](const Tile& tile, std::uint64_t seed,
                                                         Image& image, std::uint64_t& rays) {
        return draw_pixels(tile, image, [&](int x, int y) {
            return (*renderer)(JitteredSamples{seed, count}, x, y, rays);
        });
    };
}

constexpr auto makers =
    ::effects::for_few_effects([]<Effects effects> { return &make_drawing<effects>; });

}  // namespace
}  // namespace triangles

effects::TileRenderer effects::make_meshed(const rt::SceneDescription& scene, int width, int height,
                                           const rt::Quality& quality) {
    const std::size_t number = rt::narrowest(rt::needed_effects(scene), few_effects);
    const DrawTile draw = triangles::makers[number](scene, width, height, quality);
    return {choice_of(few_effects, number), [draw] { return draw; }};
}

app::Picture effects::show_meshed(rt::SceneDescription scene, const app::Settings& settings,
                                  app::Progress& progress) {
    hold_still(scene.camera, settings.show);
    return rt::show_ready(rt::MeshScene<rt::every_effect>{scene, settings.width, settings.height},
                          settings, progress);
}

rt::Mesh effects::read_mesh(const std::string& bytes, std::optional<bool> smooth) {
    rt::Mesh mesh = rt::make_mesh(rt::read_obj(bytes));
    if (mesh.triangles.empty()) throw std::invalid_argument("it has no polygons");
    const bool has_normals = !mesh.normals.empty();
    if (!smooth.value_or(has_normals)) {
        for (auto& triangle : mesh.triangles)
            for (rt::Corner& corner : triangle) corner.normal = -1;
        mesh.normals.clear();
    } else {
        add_normals(mesh);
    }
    return mesh;
}
