#pragma once
#include <memory>
#include <rt/mesh_materials.hpp>
#include <rt/mesh_world.hpp>
#include <rt/ready_scene.hpp>
#include <vector>

namespace rt {

// A surface of triangles (given).
struct MeshDescription {
    std::shared_ptr<const Mesh> mesh;
    Mat4 object_to_world;  // not singular
    int material = 0;      // an index into the scene's materials; not an Emitter
};

// A scene that may have meshes, too (given).
struct MeshedDescription : SceneDescription {
    std::vector<MeshDescription> meshes;
};

template <class Use>
void for_other_shapes(const MeshedDescription& scene, const Use& use) {
    for_other_shapes(static_cast<const SceneDescription&>(scene), use);
    for (const MeshDescription& mesh : scene.meshes) use(mesh.material);
}

// The meshes of a scene, put at their places.
inline SceneMeshes meshes_of(const MeshedDescription& scene) {
    SceneMeshes meshes;
    for (const MeshDescription& mesh : scene.meshes)
        meshes.add(*mesh.mesh, mesh.object_to_world, mesh.material);
    return meshes;
}

// A scene with meshes, made ready for a renderer with these effects (given): chapter 08's
// ReadyScene, with the triangles in a tree of their own beside the spheres, and with materials that
// know the mesh.
template <Effects effects>
struct MeshScene : ReadyScene<effects> {
    using Spheres = ReadyScene<effects>;
    Mesh mesh;
    Aggregate<decltype(Spheres::world), TriangleTree> world;
    MeshMaterials<decltype(Spheres::materials)> materials;

    MeshScene(const SceneDescription& scene, int width, int height, SceneMeshes meshes)
        : Spheres{scene, width, height},
          mesh{std::move(meshes.mesh)},
          world{std::move(Spheres::world), make_wide_tree(meshes.triangles)},
          materials{std::move(Spheres::materials), &mesh} {}
    MeshScene(const MeshScene&) = delete;
    MeshScene& operator=(const MeshScene&) = delete;
};

}  // namespace rt
