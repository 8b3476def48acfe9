#pragma once
#include <map>
#include <rt/make_mesh.hpp>
#include <rt/teapot.hpp>

namespace rt {

// A point of a Bézier curve with four control points, at s in [0, 1] (given).
// Source: Bernstein's polynomials of degree 3.
inline Vec3 bezier(const std::array<Vec3, 4>& p, Real s) {
    const Real r = 1 - s;
    return r * r * r * p[0] + 3 * r * r * s * p[1] + 3 * r * s * s * p[2] + s * s * s * p[3];
}

// Builds the teapot's mesh, patch by patch (given).
class TeapotBuilder {
  public:
    explicit TeapotBuilder(int n) : n_{n} {}

    // Adds a patch, with y up. It is mirrored along x or z if the factor mirror_x or mirror_z is
    // -1. In the texture, the patch's first column is at x = `from`, and its last column at x =
    // `to`.
    void add(const teapot::Patch& patch, Real mirror_x, Real mirror_z, Real from, Real to) {
        std::vector<Corner> corners;
        for (int row = 0; row <= n_; ++row)
            for (int column = 0; column <= n_; ++column) {
                const Real down = share(row), around = share(column);
                std::array<Vec3, 4> curve;
                for (std::size_t i = 0; i < 4; ++i) {
                    std::array<Vec3, 4> control;
                    for (std::size_t k = 0; k < 4; ++k) {
                        const auto& p = teapot::points[static_cast<std::size_t>(patch[4 * i + k])];
                        control[k] = {mirror_x * static_cast<Real>(p[0]), static_cast<Real>(p[2]),
                                      mirror_z * -static_cast<Real>(p[1])};
                    }
                    curve[i] = bezier(control, around);
                }
                const Vec3 point = bezier(curve, down);
                mesh.uvs.push_back({from + around * (to - from), point.y / height});
                corners.push_back({number_of(point), -1, static_cast<int>(mesh.uvs.size()) - 1});
            }
        const bool turned = mirror_x * mirror_z > 0;  // Newell's patches go around clockwise
        for (int row = 0; row < n_; ++row)
            for (int column = 0; column < n_; ++column) {
                const auto at = [&](int r, int c) {
                    return corners[static_cast<std::size_t>(r * (n_ + 1) + c)];
                };
                const Corner a = at(row, column), b = at(row, column + 1),
                             c = at(row + 1, column + 1), d = at(row + 1, column);
                add_triangle(turned ? std::array{a, b, c} : std::array{a, c, b});
                add_triangle(turned ? std::array{a, c, d} : std::array{a, d, c});
            }
    }

    Mesh mesh;

  private:
    static constexpr Real height = Real(3.15);

    Real share(int k) const { return static_cast<Real>(k) / static_cast<Real>(n_); }

    // Points with the same coordinates become one point. Neighboring patches share their edges, and
    // for the patches in the middle of the lid and of the bottom, one edge is a single point.
    int number_of(Vec3 p) {
        const auto [found, is_new] =
            numbers_.insert({{p.x, p.y, p.z}, static_cast<int>(mesh.points.size())});
        if (is_new) mesh.points.push_back(p);
        return found->second;
    }
    void add_triangle(const std::array<Corner, 3>& t) {
        if (t[0].point == t[1].point || t[1].point == t[2].point || t[2].point == t[0].point)
            return;
        mesh.triangles.push_back(t);
    }

    int n_;
    std::map<std::array<Real, 3>, int> numbers_;
};

// A range of the teapot's patches: all patches, or those of a part.
struct TeapotParts {
    std::size_t first = 0, end = teapot::patches.size();
};
inline constexpr TeapotParts whole_teapot, teapot_body{0, 3}, teapot_lid{3, 5};
inline constexpr TeapotParts teapot_bottom{5, 6}, teapot_handle_and_spout{6, 10};

// The teapot as a mesh with smooth normals and texture coordinates (given): each patch is cut into
// n x n squares, n at least 1, and each square into two triangles. y is up, the spout points along
// x, the bottom is at y = 0, and the body's radius is 2. Neighboring patches share points. Even so,
// there are gaps where Newell left them: below the lid, and where spout and handle run into the
// body.
inline Mesh make_teapot(int n, const TeapotParts& parts = whole_teapot) {
    TeapotBuilder builder{n};
    for (std::size_t i = parts.first; i < parts.end; ++i) {
        const auto& patch = teapot::patches[i];
        const bool quarters = i < teapot::four_quarters;
        builder.add(patch, 1, 1, 0, quarters ? Real(0.25) : Real(0.5));
        builder.add(patch, 1, -1, 1, quarters ? Real(0.75) : Real(0.5));
        if (!quarters) continue;
        builder.add(patch, -1, 1, Real(0.5), Real(0.25));
        builder.add(patch, -1, -1, Real(0.5), Real(0.75));
    }
    add_normals(builder.mesh);
    return builder.mesh;
}

}  // namespace rt
