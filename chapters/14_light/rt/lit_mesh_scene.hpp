#pragma once
#include <rt/mesh_scene.hpp>
#include <rt/two_way_path.hpp>

namespace rt {

// Whether what is made of this material shines (given).
inline bool shines(const MaterialDescription& material) {
    const auto* const emitter = std::get_if<Emitter>(&material);
    return emitter && emitter->radiance != Color{};
}

// The triangles of these meshes that shine (given).
inline std::vector<LampTriangle> lamp_triangles(const SceneDescription& scene,
                                                const SceneMeshes& meshes) {
    std::vector<LampTriangle> lamps;
    for (const PlacedMesh& mesh : meshes.placed())
        for (int number = mesh.first(); number < mesh.first() + mesh.size(); ++number) {
            const auto& material = scene.materials[static_cast<std::size_t>(mesh.material(number))];
            if (shines(material))
                lamps.push_back(
                    {mesh.triangle(number).shape, std::get<Emitter>(material).radiance, number});
        }
    return lamps;
}

// A scene with meshes that shine, made ready for a renderer with these effects (given).
template <Effects effects, class Lamps = MeshLights>
struct LitMeshScene : MeshScene<effects> {
    LightsByWays<Lamps> lights;

    LitMeshScene(const SceneDescription& scene, int width, int height, SceneMeshes placed,
                 Ways ways = Ways::power)
        : LitMeshScene{{{prepare_shapes(scene).lights, lamp_triangles(scene, placed)}, ways},
                       scene,
                       width,
                       height,
                       std::move(placed)} {}

  private:
    LitMeshScene(LightsByWays<Lamps> lamps, const SceneDescription& scene, int width, int height,
                 SceneMeshes placed)
        : MeshScene<effects>{scene, width, height, std::move(placed)}, lights{std::move(lamps)} {}
};

}  // namespace rt
