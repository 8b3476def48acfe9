#pragma once
#include <rt/aggregate.hpp>
#include <rt/inverse.hpp>
#include <rt/make_mesh.hpp>
#include <rt/transform.hpp>
#include <rt/triangle_leaf.hpp>
#include <rt/wide_builder.hpp>
#include <vector>

namespace rt {

// The triangles of a scene (given): all meshes of the scene, put at their places and joined into
// one mesh, and a list of all triangles with their materials.
struct SceneMeshes {
    Mesh mesh;
    std::vector<SceneTriangle> triangles;

    // Adds a mesh. The matrix object_to_world, which must not be singular, takes its points to
    // their places in the world.
    void add(const Mesh& part, const Mat4& object_to_world, int material) {
        const Mat4 back = inverse(object_to_world);
        const auto moved = [](int number, std::size_t by) {
            return number < 0 ? number : number + static_cast<int>(by);
        };
        Mesh placed;
        placed.triangles = part.triangles;
        for (const Vec3& point : part.points)
            placed.points.push_back(transform_point(object_to_world, point));
        const std::vector<SceneTriangle> added =
            triangles_of(placed, material, static_cast<int>(triangles.size()));
        triangles.insert(triangles.end(), added.begin(), added.end());
        for (auto& triangle : placed.triangles) {
            for (Corner& corner : triangle)
                corner = {moved(corner.point, mesh.points.size()),
                          moved(corner.normal, mesh.normals.size()),
                          moved(corner.uv, mesh.uvs.size())};
            mesh.triangles.push_back(triangle);
        }
        mesh.points.insert(mesh.points.end(), placed.points.begin(), placed.points.end());
        for (const Vec3& normal : part.normals) {
            const Vec3 turned = transform_normal(back, normal);
            mesh.normals.push_back(turned == Vec3{} ? turned : normalize(turned));
        }
        mesh.uvs.insert(mesh.uvs.end(), part.uvs.begin(), part.uvs.end());
    }
};

}  // namespace rt
