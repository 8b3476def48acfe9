#pragma once
#include <rt/mesh_materials.hpp>
#include <rt/mesh_world.hpp>
#include <rt/renderer.hpp>

namespace rt {

// A scene with meshes, made ready for a renderer with these effects (given): what chapter 08 makes
// ready, with the triangles in a tree of their own. The description must outlive it.
template <Effects effects>
struct MeshScene {
    using Types = RendererTypes<effects>;
    ReadyScene<effects> ready;  // without its world and its materials
    Mesh mesh;
    Aggregate<typename Types::World, TriangleTree> world;
    MeshMaterials<typename Types::Materials> materials;

    MeshScene(const SceneDescription& scene, SceneMeshes meshes, int width, int height)
        : ready{scene, width, height},
          mesh{std::move(meshes.mesh)},
          world{std::move(ready.world), make_wide_tree(meshes.triangles)},
          materials{std::move(ready.materials), &mesh} {}
    MeshScene(const MeshScene&) = delete;
    MeshScene& operator=(const MeshScene&) = delete;

    // The light along one path.
    template <class World, class AnyRay, class Random>
    Color radiance(const World& in, const AnyRay& ray, int depth, Random& random) const {
        if constexpr (effects.lights || effects.fog)
            return lit_path_radiance(ray, in, materials, ready.sky, ready.lights, ready.fog,
                                     SkyEnding{}, depth, random);
        else
            return path_radiance(ray, in, materials, ready.sky, SkyEnding{}, depth, random);
    }

    // The color of a pixel, as Renderer of chapter 08 computes it; counts the rays.
    Color pixel(const JitteredSamples& samples, int depth, int column, int row,
                std::uint64_t& rays) const {
        const CountingWorld<decltype(world)> counting{world, rays};
        return samples.average(ready.camera, column, row, [&](const auto& ray, auto& random) {
            return through_haze(ready.haze, radiance(counting, ray, depth, random),
                                [&] { return distance_ahead(counting, ray); });
        });
    }
};

}  // namespace rt
