#pragma once
#include <rt/bilinear.hpp>
#include <rt/fuzz_density.hpp>
#include <rt/mesh_world.hpp>
#include <rt/off_edges.hpp>
#include <rt/path_vertex.hpp>
#include <rt/placed_mesh.hpp>
#include <rt/renderer_materials.hpp>
#include <rt/smooth_normal.hpp>
#include <rt/spread.hpp>
#include <rt/triangle_number.hpp>

namespace rt {

// What a hit of a triangle does not contain (given): the weights of the corners, and what is
// computed with them.

// The weights of b and c at a point of a triangle, of any size.
inline Vec2 weights_at(const Triangle& triangle, Vec3 point) {
    Vec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a, from_a = point - triangle.a;
    // The fourth power of a length would underflow. A power of two changes no digit.
    const Real size = std::max(max_component(ab), max_component(ac));
    const Real scale = std::ldexp(Real(1), -std::ilogb(size));
    ab *= scale;
    ac *= scale;
    from_a *= scale;
    const Vec3 normal = cross(ab, ac);
    const Real whole = dot(normal, normal);
    return {dot(cross(from_a, ac), normal) / whole, dot(cross(ab, from_a), normal) / whole};
}

// The triangle that was hit.
inline Triangle triangle_of(const SceneMeshes& meshes, const Hit& hit) {
    const int number = triangle_number(hit);
    return meshes.mesh_of(number).triangle(number).shape;
}

// The same, and the weights of its corners at the hit.
class MeshPoint {
  public:
    MeshPoint(const SceneMeshes& meshes, const Hit& hit)
        : mesh_{meshes.mesh_of(triangle_number(hit))},
          corners_{mesh_.corners(triangle_number(hit))},
          triangle_{mesh_.triangle(triangle_number(hit)).shape} {
        if (has_normals() || has_uvs() || has_colors()) weights_ = weights_at(triangle_, hit.point);
    }
    bool has_normals() const {
        return corners_[0].normal >= 0 && corners_[1].normal >= 0 && corners_[2].normal >= 0;
    }
    bool has_uvs() const {
        return corners_[0].uv >= 0 && corners_[1].uv >= 0 && corners_[2].uv >= 0;
    }
    bool has_colors() const { return mesh_.shows_colors(); }
    // The normal of the curved surface that the triangle stands for.
    Vec3 normal(Vec3 flat) const {
        if (!has_normals()) return flat;
        return smooth_normal(normals(), weights_.x, weights_.y, flat);
    }
    // The way from the point to where light over the triangle's horizon leaves, on the side of
    // `facing`, the flat normal or its opposite.
    Vec3 lift(Vec3 facing) const {
        if (!has_normals()) return {};
        std::array<Vec3, 3> on_this_side = normals();
        for (Vec3& normal : on_this_side)
            if (dot(normal, facing) < 0) normal = -normal;
        return rt::lift(triangle_, on_this_side, weights_.x, weights_.y);
    }
    // The texture coordinates.
    Vec2 uv() const {
        const Vec2 a = mesh_.uv(corners_[0]), b = mesh_.uv(corners_[1]), c = mesh_.uv(corners_[2]);
        const Real u = weights_.x, v = weights_.y, rest = 1 - u - v;
        return {rest * a.x + u * b.x + v * c.x, rest * a.y + u * b.y + v * c.y};
    }

    // The color between those of the corners.
    Color color() const {
        const Real u = weights_.x, v = weights_.y;
        return (1 - u - v) * mesh_.color(corners_[0]) + u * mesh_.color(corners_[1]) +
               v * mesh_.color(corners_[2]);
    }

  private:
    std::array<Vec3, 3> normals() const {
        return {mesh_.normal(corners_[0]), mesh_.normal(corners_[1]), mesh_.normal(corners_[2])};
    }

    const PlacedMesh& mesh_;
    PlacedMesh::Corners corners_;
    Triangle triangle_;
    Vec2 weights_;
};

// The image that the material of a hit shows, or null if it shows none.
template <class Material>
const Image* image_of(const MaterialList<Material>&, const Hit&) {
    return nullptr;
}
template <class... Types>
const Image* image_of(const MaterialSet<Types...>& set, const Hit& hit) {
    if constexpr ((std::is_same_v<Types, ImageMatte> || ...)) {
        const auto* const picture =
            std::get_if<ImageMatte>(&set.materials[static_cast<std::size_t>(hit.material)]);
        return picture ? picture->image : nullptr;
    } else {
        return nullptr;
    }
}

// The materials of a scene with meshes (given): on a triangle, they scatter light with the smooth
// normal, and keep_side keeps the light on the right side of the flat triangle. The texture
// coordinates of the mesh say where an image lies on it.
template <class Materials>
struct MeshMaterials {
    Materials materials;
    const SceneMeshes* meshes = nullptr;
    // Where rays start at leaving_point(), the scene's triangles: matte light may then run over a
    // triangle's horizon, above the smooth normal and below the flat one. Null: it may not.
    const MeshWorld* triangles = nullptr;

    bool is_matte(const Hit& hit) const {
        return scatter_density(materials, hit, facing_normal(hit)) > 0;
    }

    // How far light over the horizon is lifted; zero if the surface is not curved outward here, or
    // if the light would start beyond another triangle.
    Vec3 free_lift(const Hit& hit, const MeshPoint& at) const {
        if (!triangles) return {};
        const Vec3 up = facing_normal(hit), lift = at.lift(up);
        if (!(max_component(lift) > hit.point_error)) return {};  // none, but for rounding
        // Twice as far, so that it does not start right before a triangle, either.
        const bool blocked = triangles->occluded(Ray{leave_surface(hit, up), lift}, {0, 2});
        return blocked ? Vec3{} : lift;
    }

    template <class Random>
    std::optional<Scatter> operator()(Vec3 incoming, const Hit& hit, Random& random) const {
        if (!is_triangle(hit)) return materials(incoming, hit, random);
        const MeshPoint at{*meshes, hit};
        Hit smooth = hit;
        smooth.normal = at.normal(hit.normal);
        // A material that scatters light in all directions needs no bent normal. Besides,
        // scatter_density, which knows no `incoming`, could not take the bending into account.
        const bool matte = is_matte(hit);
        if (!matte) smooth.normal = bent_normal(smooth.normal, hit.normal, incoming);
        const Image* const image = image_of(materials, hit);
        const auto matte_in = [&](const Color& albedo) {
            return scatter(Lambertian{albedo}, incoming, smooth, random);
        };
        std::optional<Scatter> bounce = image && at.has_uvs() ? matte_in(bilinear(*image, at.uv()))
                                        : at.has_colors()     ? matte_in(at.color())
                                                              : materials(incoming, smooth, random);
        if (!bounce) return {};
        const bool over_horizon = matte && !(dot(bounce->direction, facing_normal(hit)) > 0);
        if (!over_horizon || free_lift(hit, at) == Vec3{})
            bounce->direction = keep_side(bounce->direction, smooth.normal, hit.normal);
        return bounce;
    }
};

// The probability density with which a material on a mesh scatters light in this direction. The
// direction can be the material's own choice, or, where light cannot run over the horizon, the
// mirror image of that choice, made by keep_side.
template <class Materials>
Real scatter_density(const MeshMaterials<Materials>& set, const Hit& hit, Vec3 direction) {
    if (!is_triangle(hit)) return scatter_density(set.materials, hit, direction);
    const bool above = dot(direction, facing_normal(hit)) > 0;
    if (!above && !set.triangles) return 0;
    const MeshPoint at{*set.meshes, hit};
    Hit smooth = hit;
    smooth.normal = at.normal(hit.normal);
    const Real own = scatter_density(set.materials, smooth, direction);
    if (!above) return own > 0 && set.free_lift(hit, at) != Vec3{} ? own : Real(0);
    const Real mirrored = scatter_density(set.materials, smooth, reflect(direction, hit.normal));
    return mirrored > 0 && set.free_lift(hit, at) != Vec3{} ? own : own + mirrored;
}

// Light leaves off the triangle's edges, and above the triangle if it runs over the horizon.
template <class Materials>
Vec3 leaving_point(const MeshMaterials<Materials>& set, const Hit& hit, Vec3 direction) {
    if (!is_triangle(hit)) return leave_surface(hit, direction);
    const Vec3 up = facing_normal(hit);
    if (!set.triangles || dot(direction, up) > 0 || !set.is_matte(hit))
        return leave_surface(off_edges(triangle_of(*set.meshes, hit), hit), direction);
    Hit raised = hit;
    raised.point += MeshPoint{*set.meshes, hit}.lift(up);
    raised.point_error += rounding_bound(1) * dot(abs(raised.point), abs(up));
    return leave_surface(raised, up);
}

// The same, but on spheres including the density of rough metal: see fuzz_density.hpp. The smooth
// normal of a mesh may have been bent, and with it the mirror direction.
template <class Materials>
Real scatter_density(const MeshMaterials<Materials>& set, Vec3 incoming, const Hit& hit,
                     Vec3 direction) {
    return is_triangle(hit) ? scatter_density(set, hit, direction)
                            : scatter_density(set.materials, incoming, hit, direction);
}

template <class Materials>
bool came_through_glass(const MeshMaterials<Materials>& set, const Hit& hit) {
    return came_through_glass(set.materials, hit);
}

}  // namespace rt
