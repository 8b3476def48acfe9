#pragma once
#include <rt/bilinear.hpp>
#include <rt/mesh.hpp>
#include <rt/renderer_materials.hpp>
#include <rt/smooth_normal.hpp>
#include <rt/spread.hpp>
#include <rt/triangle.hpp>
#include <rt/triangle_number.hpp>

namespace rt {

// What a hit of a triangle does not contain (given): the weights of the corners, and what is
// computed with them.

// The weights of b and c at a point of a triangle.
inline Vec2 weights_at(const Triangle& triangle, Vec3 point) {
    const Vec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a,
               from_a = point - triangle.a;
    const Vec3 normal = cross(ab, ac);
    const Real whole = dot(normal, normal);
    return {dot(cross(from_a, ac), normal) / whole, dot(cross(ab, from_a), normal) / whole};
}

// The triangle that was hit, and the weights of its corners at the hit.
class MeshPoint {
  public:
    MeshPoint(const Mesh& mesh, const Hit& hit)
        : mesh_{mesh}, corners_{mesh.triangles[static_cast<std::size_t>(triangle_number(hit))]} {
        const auto point = [&](std::size_t k) {
            return mesh.points[static_cast<std::size_t>(corners_[k].point)];
        };
        if (has_normals() || has_uvs())
            weights_ = weights_at({point(0), point(1), point(2)}, hit.point);
    }
    bool has_normals() const {
        return corners_[0].normal >= 0 && corners_[1].normal >= 0 && corners_[2].normal >= 0;
    }
    bool has_uvs() const {
        return corners_[0].uv >= 0 && corners_[1].uv >= 0 && corners_[2].uv >= 0;
    }
    // The normal of the curved surface that the triangle stands for.
    Vec3 normal(Vec3 flat) const {
        if (!has_normals()) return flat;
        std::array<Vec3, 3> normals;
        for (std::size_t k = 0; k < 3; ++k)
            normals[k] = mesh_.normals[static_cast<std::size_t>(corners_[k].normal)];
        return smooth_normal(normals, weights_.x, weights_.y, flat);
    }
    // The texture coordinates.
    Vec2 uv() const {
        const auto at = [&](std::size_t k) {
            return mesh_.uvs[static_cast<std::size_t>(corners_[k].uv)];
        };
        const Vec2 a = at(0), b = at(1), c = at(2);
        const Real u = weights_.x, v = weights_.y, rest = 1 - u - v;
        return {rest * a.x + u * b.x + v * c.x, rest * a.y + u * b.y + v * c.y};
    }

  private:
    const Mesh& mesh_;
    const std::array<Corner, 3>& corners_;
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
    const Mesh* mesh = nullptr;

    template <class Random>
    std::optional<Scatter> operator()(Vec3 incoming, const Hit& hit, Random& random) const {
        if (!is_triangle(hit)) return materials(incoming, hit, random);
        const MeshPoint at{*mesh, hit};
        Hit smooth = hit;
        smooth.normal = at.normal(hit.normal);
        // A material that scatters light in all directions needs no bent normal. Besides,
        // scatter_density, which knows no `incoming`, could not take the bending into account.
        if (!(scatter_density(materials, smooth, facing_normal(smooth)) > 0))
            smooth.normal = bent_normal(smooth.normal, hit.normal, incoming);
        const Image* const image = image_of(materials, hit);
        std::optional<Scatter> bounce =
            image && at.has_uvs()
                ? scatter(Lambertian{bilinear(*image, at.uv())}, incoming, smooth, random)
                : materials(incoming, smooth, random);
        if (bounce) bounce->direction = keep_side(bounce->direction, smooth.normal, hit.normal);
        return bounce;
    }
};

// The probability density with which a material on a mesh scatters light in this direction. The
// direction can be the material's own choice, or the mirror image of that choice, made by
// keep_side.
template <class Materials>
Real scatter_density(const MeshMaterials<Materials>& set, const Hit& hit, Vec3 direction) {
    if (!is_triangle(hit)) return scatter_density(set.materials, hit, direction);
    if (!(dot(direction, facing_normal(hit)) > 0)) return 0;
    Hit smooth = hit;
    smooth.normal = MeshPoint{*set.mesh, hit}.normal(hit.normal);
    return scatter_density(set.materials, smooth, direction) +
           scatter_density(set.materials, smooth, reflect(direction, hit.normal));
}

template <class Materials>
bool came_through_glass(const MeshMaterials<Materials>& set, const Hit& hit) {
    return came_through_glass(set.materials, hit);
}

}  // namespace rt
