// What chapter 08's program draws scenes with meshes with. It is linked into that program.

#include <array>
#include <memory>
#include <rt/choose_renderer.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/mesh_renderer.hpp>
#include <rt/needed_effects.hpp>
#include <rt/render_tiles.hpp>
#include <rt/show_paths.hpp>
#include <stdexcept>
#include <utility>

#include "few_effects.hpp"
#include "tile_renderer.hpp"

namespace triangles {
namespace {

using namespace rt;
using effects::DrawTile, effects::few_effects;

SceneMeshes meshes_of(const SceneDescription& scene) {
    SceneMeshes meshes;
    for (const MeshDescription& mesh : scene.meshes)
        meshes.add(*mesh.mesh, mesh.object_to_world, mesh.material);
    return meshes;
}

template <Effects effects>
DrawTile make_drawing(const SceneDescription& description, int width, int height,
                      const Quality& quality) {
    const auto scene = std::make_shared<const MeshScene<effects>>(
        description, meshes_of(description), width, height);
    return
        [scene, quality](const Tile& tile, std::uint64_t seed, Image& image, std::uint64_t& rays) {
            const JitteredSamples samples{seed, quality.samples_per_pixel};
            std::int64_t done = 0;
            for_each_pixel(tile, [&](int x, int y) {
                if (app::Interruption::signal() != 0) return;
                image.at(x, y) = scene->pixel(samples, quality.depth, x, y, rays);
                ++done;
            });
            return done;
        };
}

constexpr auto makers = []<std::size_t... number>(std::index_sequence<number...>) {
    return std::array{make_drawing<few_effects[number]>...};
}
(std::make_index_sequence<few_effects.size()>{});

}  // namespace
}  // namespace triangles

effects::TileRenderer effects::make_meshed(const rt::SceneDescription& scene, int width, int height,
                                           const rt::Quality& quality) {
    const std::size_t number = rt::narrowest(rt::needed_effects(scene), few_effects);
    const rt::Effects chosen = few_effects[number];
    const DrawTile draw = triangles::makers[number](scene, width, height, quality);
    return {{chosen, without(few_effects.back(), chosen), few_effects.size()},
            [draw] { return draw; }};
}

app::Picture effects::show_meshed(const rt::SceneDescription& scene, const app::Settings& settings,
                                  app::Progress& progress) {
    rt::SceneDescription still = scene;
    if (settings.show != "bounces" && settings.show != "samples") {
        still.camera.lens = {};
        still.camera.shutter = 0;
    }
    const rt::MeshScene<rt::every_effect> ready{still, triangles::meshes_of(still), settings.width,
                                                settings.height};
    const auto path = [&](const auto& ray, const auto& world, rt::Rng& random) {
        return ready.radiance(world, ray, settings.depth, random);
    };
    return rt::show_world(settings, progress, ready.ready.camera, ready.world, path,
                          rt::render_tiles);
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
