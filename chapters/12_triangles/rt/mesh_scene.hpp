#pragma once
#include <memory>
#include <rt/mesh_materials.hpp>
#include <rt/mesh_world.hpp>
#include <rt/ready_scene.hpp>
#include <set>
#include <vector>

namespace rt {

// A surface of triangles (given).
struct MeshDescription {
    std::shared_ptr<const Mesh> mesh;
    Mat4 object_to_world;              // not singular
    int material = 0;                  // an index into the scene's materials
    TriangleMaterials materials = {};  // of each triangle; null: `material` for all
    bool shows_colors = false;  // those of the mesh's points take the place of the material's
};

// A scene that may have meshes, too (given).
struct MeshedDescription : SceneDescription {
    std::vector<MeshDescription> meshes;
    std::vector<std::string> notes = {};  // what of the files is not drawn, a line each
};

template <class Use>
void for_other_shapes(const MeshedDescription& scene, const Use& use) {
    for_other_shapes(static_cast<const SceneDescription&>(scene), use);
    std::set<TriangleMaterials> seen;
    for (const MeshDescription& mesh : scene.meshes) {
        if (!mesh.materials)
            use(mesh.material);
        else if (seen.insert(mesh.materials).second)
            for (const int material : std::set<int>(mesh.materials->begin(), mesh.materials->end()))
                use(material);
    }
}

// The meshes of a scene, put at their places.
inline SceneMeshes meshes_of(const MeshedDescription& scene) {
    SceneMeshes meshes;
    for (const MeshDescription& mesh : scene.meshes)
        meshes.add(mesh.mesh, mesh.object_to_world, mesh.material, mesh.materials,
                   mesh.shows_colors);
    return meshes;
}

// A scene with meshes, made ready for a renderer with these effects (given): chapter 08's
// ReadyScene, with the triangles in trees of their own beside the spheres, and with materials that
// know the meshes.
template <Effects effects>
struct MeshScene : ReadyScene<effects> {
    using Spheres = ReadyScene<effects>;
    std::shared_ptr<const SceneMeshes> meshes;
    Aggregate<decltype(Spheres::world), MeshWorld> world;
    MeshMaterials<decltype(Spheres::materials)> materials;

    MeshScene(const SceneDescription& scene, int width, int height, SceneMeshes placed)
        : Spheres{scene, width, height},
          meshes{with_copies(std::move(placed))},
          world{std::move(Spheres::world), MeshWorld{meshes}},
          materials{std::move(Spheres::materials), meshes.get(),
                    effects.lights ? &world.second : nullptr} {}
    MeshScene(const MeshScene&) = delete;
    MeshScene& operator=(const MeshScene&) = delete;

  private:
    static std::shared_ptr<const SceneMeshes> with_copies(SceneMeshes placed) {
        placed.make_copies();
        return std::make_shared<const SceneMeshes>(std::move(placed));
    }
};

}  // namespace rt
