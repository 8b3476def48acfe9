#pragma once
// What the picture of chapter 12 shows on the right of its cut: triangles that are few, flat, and
// have wires around them.

#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/make_teapot.hpp>
#include <rt/mesh.hpp>
#include <rt/transform.hpp>

namespace triangles {

using namespace rt;

// Flat triangles, and the wires around them.
struct Facets {
    Mesh faces, wires;

    // The wire covers the outermost part of the triangle, on its inside.
    void add(const Mesh& mesh, const std::array<Corner, 3>& triangle) {
        const auto corner = [&](std::size_t i) {
            return mesh.points[static_cast<std::size_t>(triangle[i].point)];
        };
        const Vec3 middle = (corner(0) + corner(1) + corner(2)) / 3;
        const int outer = number_of_next(wires), inner = number_of_next(faces);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 within = middle + Real(0.93) * (corner(i) - middle);
            faces.points.push_back(within);
            wires.points.insert(wires.points.end(), {corner(i), within});
        }
        faces.triangles.push_back({Corner{inner}, Corner{inner + 1}, Corner{inner + 2}});
        for (int i = 0; i < 3; ++i) {
            const int next = (i + 1) % 3;
            const Corner a{outer + 2 * i}, b{outer + 2 * next}, c{b.point + 1}, d{a.point + 1};
            wires.triangles.push_back({a, b, c});
            wires.triangles.push_back({a, c, d});
        }
    }

  private:
    static int number_of_next(const Mesh& mesh) { return static_cast<int>(mesh.points.size()); }
};

// A plane through the eye, which cuts the picture along a line.
class Cut {
  public:
    // Along the line between two points, seen from `eye`. What is on its right is made of facets.
    Cut(Vec3 eye, Vec3 top, Vec3 bottom) : eye_{eye}, right_{cross(bottom - eye, top - eye)} {}

    bool is_right_of(Vec3 p) const { return dot(right_, p - eye_) > 0; }

  private:
    Vec3 eye_, right_;
};

// A part of the teapot: on the left of the cut, with 24 x 24 squares in each patch and smooth
// normals; on the right, with 4 x 4 and flat. No square of the part may be a single triangle, as
// those in the middle of the lid are.
struct CutPart {
    Mesh smooth;
    Facets facets;
};
inline CutPart cut_part(const TeapotParts& parts, const Mat4& to_world, const Cut& cut) {
    constexpr std::size_t few = 4, many = 24, block = many / few;
    const Mesh coarse = make_teapot(few, parts), fine = make_teapot(many, parts);
    CutPart part{fine, {}};
    part.smooth.triangles.clear();
    for (std::size_t square = 0; 2 * square < coarse.triangles.size(); ++square) {
        const auto& first = coarse.triangles[2 * square];
        const Vec3 corner = coarse.points[static_cast<std::size_t>(first[0].point)];
        if (cut.is_right_of(transform_point(to_world, corner))) {
            part.facets.add(coarse, first);
            part.facets.add(coarse, coarse.triangles[2 * square + 1]);
            continue;
        }
        const std::size_t patch = square / (few * few), row = square / few % few;
        const std::size_t column = square % few;
        for (std::size_t i = 0; i < block; ++i) {
            const std::size_t begin =
                2 * ((patch * many + row * block + i) * many + column * block);
            for (std::size_t k = 0; k < 2 * block; ++k)
                part.smooth.triangles.push_back(fine.triangles[begin + k]);
        }
    }
    return part;
}

}  // namespace triangles
