#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <rt/close_cracks.hpp>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/inverse.hpp>
#include <rt/length.hpp>
#include <rt/mesh.hpp>
#include <rt/placed_sphere.hpp>
#include <rt/transform.hpp>
#include <rt/triangle_shape.hpp>
#include <utility>
#include <vector>

namespace rt {

// The material of each triangle of a mesh; shared by all places of the mesh.
using TriangleMaterials = std::shared_ptr<const std::vector<int>>;

// A mesh at one place in the world (given). The mesh itself is stored once, however often it is
// placed. The points and normals of a copy are kept, unless it is very large; all others are
// computed when they are asked for, in the same way, so that copies and instances have the same
// bits.
class PlacedMesh {
  public:
    // The matrix object_to_world, which must not be singular, takes the mesh's points to their
    // places in the world. The material is that of all triangles, unless `materials` has one for
    // each. If `shows_colors`, the surface is matte and has the colors of the mesh's points. The
    // triangles' numbers in the scene begin at `first`.
    PlacedMesh(std::shared_ptr<const Mesh> mesh, const Mat4& object_to_world, int material,
               TriangleMaterials materials, bool shows_colors, int first)
        : mesh_{std::move(mesh)},
          instance_{make_instance(object_to_world, material)},
          materials_{std::move(materials)},
          shows_colors_{shows_colors},
          first_{first} {
        const Mat4& m = object_to_world;
        is_mirrored_ = dot(cross(transform_vector(m, {1, 0, 0}), transform_vector(m, {0, 1, 0})),
                           transform_vector(m, {0, 0, 1})) < 0;
    }

    const Mesh& mesh() const { return *mesh_; }
    const std::shared_ptr<const Mesh>& shared_mesh() const { return mesh_; }
    // The matrices, for object_ray of 08.5.
    const Instance& instance() const { return instance_; }
    int first() const { return first_; }
    int size() const { return static_cast<int>(mesh_->triangles.size()); }

    // Where a point of the mesh is in the world.
    Vec3 placed(Vec3 point) const { return transform_point(instance_.object_to_world, point); }
    // A mirror turns the way around a triangle, and so its outside, around.
    bool is_mirrored() const { return is_mirrored_; }

    using Corners = std::array<Corner, 3>;
    // The corners of the triangle with this number in the scene, counterclockwise as seen from
    // outside.
    Corners corners(int number) const {
        Corners at = mesh_->triangles[static_cast<std::size_t>(number - first_)];
        if (is_mirrored_) std::swap(at[1], at[2]);
        return at;
    }
    Vec3 point(const Corner& corner) const {
        const auto number = static_cast<std::size_t>(corner.point);
        return keeps_points_ ? points_[number] : placed(mesh_->points[number]);
    }
    // The corner must have a normal.
    Vec3 normal(const Corner& corner) const {
        const auto number = static_cast<std::size_t>(corner.normal);
        return keeps_points_ ? normals_[number] : placed_normal(mesh_->normals[number]);
    }
    // The corner must have texture coordinates.
    Vec2 uv(const Corner& corner) const { return mesh_->uvs[static_cast<std::size_t>(corner.uv)]; }
    bool shows_colors() const { return shows_colors_; }
    Color color(const Corner& corner) const {
        return mesh_->colors[static_cast<std::size_t>(corner.point)];
    }
    int material(int number) const {
        return materials_ ? (*materials_)[static_cast<std::size_t>(number - first_)]
                          : static_cast<int>(instance_.material);
    }
    SceneTriangle triangle(int number) const {
        const auto [a, b, c] = corners(number);
        return {{point(a), point(b), point(c)}, material(number), number};
    }

    bool is_copy() const { return is_copy_; }
    void make_copy() {
        constexpr std::size_t very_large = 2'000'000;
        is_copy_ = true;
        keeps_points_ = mesh_->triangles.size() <= very_large;
        if (!keeps_points_) return;
        points_ = placed_points();
        normals_.reserve(mesh_->normals.size());
        for (const Vec3& normal : mesh_->normals) normals_.push_back(placed_normal(normal));
    }
    // All triangles of a copy.
    std::vector<SceneTriangle> triangles() const {
        // Nothing else is needed.
        Mesh copy{keeps_points_ ? points_ : placed_points(), {}, {}, mesh_->triangles};
        if (is_mirrored_)
            for (Corners& at : copy.triangles) std::swap(at[1], at[2]);
        std::vector<SceneTriangle> all =
            triangles_of(copy, static_cast<int>(instance_.material), first_);
        if (materials_)
            for (std::size_t i = 0; i < all.size(); ++i) all[i].material = (*materials_)[i];
        return all;
    }

  private:
    std::vector<Vec3> placed_points() const {
        std::vector<Vec3> points;
        points.reserve(mesh_->points.size());
        for (const Vec3& point : mesh_->points) points.push_back(placed(point));
        return points;
    }
    Vec3 placed_normal(Vec3 normal) const {
        const Vec3 turned = transform_normal(instance_.world_to_object, normal);
        return turned == Vec3{} ? turned : normalize(turned);
    }

    std::shared_ptr<const Mesh> mesh_;
    Instance instance_;
    TriangleMaterials materials_;
    bool shows_colors_;
    int first_;
    bool is_mirrored_, is_copy_ = false, keeps_points_ = false;
    std::vector<Vec3> points_, normals_;  // in the world, if they are kept
};

// Up to this many triangles in all places of a mesh, each place gets a copy. More become instances,
// which take less memory, and more time. A mesh that is placed once is copied.
inline constexpr std::int64_t most_copied = 1'000'000;

// The meshes of a scene at their places (given), in the order of their triangles' numbers.
class SceneMeshes {
  public:
    void add(std::shared_ptr<const Mesh> mesh, const Mat4& object_to_world, int material,
             TriangleMaterials materials = {}, bool shows_colors = false) {
        placed_.emplace_back(std::move(mesh), object_to_world, material, std::move(materials),
                             shows_colors, count_);
        count_ += placed_.back().size();
    }
    void add(Mesh mesh, const Mat4& object_to_world, int material) {
        std::vector<int> materials;
        close_cracks(mesh, materials);
        add(std::make_shared<const Mesh>(std::move(mesh)), object_to_world, material);
    }

    // Decides which of them are copied. Hits are the same, to the last bit, whichever it is.
    void make_copies(std::int64_t most = most_copied) {
        std::map<const Mesh*, std::int64_t> places;
        for (const PlacedMesh& placed : placed_) ++places[&placed.mesh()];
        for (PlacedMesh& placed : placed_)
            if (const auto count = places[&placed.mesh()];
                count == 1 || count * placed.size() <= most)
                placed.make_copy();
    }

    const std::vector<PlacedMesh>& placed() const { return placed_; }
    // How many triangles there are.
    int size() const { return count_; }
    // The mesh to which the triangle with this number belongs.
    const PlacedMesh& mesh_of(int number) const {
        const auto after =
            std::upper_bound(placed_.begin(), placed_.end(), number,
                             [](int n, const PlacedMesh& mesh) { return n < mesh.first(); });
        return *(after - 1);
    }

  private:
    std::vector<PlacedMesh> placed_;
    int count_ = 0;
};

}  // namespace rt
