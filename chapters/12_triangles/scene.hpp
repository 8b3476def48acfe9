#pragma once
// The scenes of chapter 12: a teapot afloat on a stormy sea of a million triangles; before that, a
// single triangle, a golden teapot of few, and a ball of few.

#include <algorithm>
#include <numbers>
#include <rt/make_ball.hpp>
#include <rt/make_teapot.hpp>
#include <rt/mesh_world.hpp>
#include <rt/portable.hpp>
#include <rt/rng.hpp>
#include <rt/scene.hpp>

#include "facets.hpp"

namespace triangles {

using namespace rt;

// The effects that the scene calls for.
inline constexpr Effects scene_effects{
    .fuzz = true, .glass = true, .texture = true, .lens = true, .lights = true};

inline View scene_view() {
    View view;
    view.from = {Real(-1.6), Real(1.9), Real(12)};
    view.at = {Real(0.15), Real(1.45), 0};
    view.vertical_fov = radians(34);
    return view;
}

// Waves whose crests are sharper than their troughs: each point of the water goes around a circle.
// Source: Gerstner, "Theorie der Wellen", 1804.
class Sea {
  public:
    Sea() {
        Rng random{12, 1};
        const auto lot = [&] { return static_cast<double>(random()) * 0x1p-32; };
        // From the swell to ripples: each wave is shorter than the one before, and runs roughly
        // with the wind.
        double length = 15;
        for (int i = 0; i < 44; ++i, length *= 0.885) {
            const double turn = 0.5 + 1.5 * (lot() - 0.5) * (i < 3 ? 0.4 : 1);
            const double height = 0.0185 * length * (0.5 + lot());
            waves_.push_back({2 * std::numbers::pi / length * rt::portable::cos(turn),
                              2 * std::numbers::pi / length * rt::portable::sin(turn),
                              rt::portable::cos(turn), rt::portable::sin(turn), height,
                              2 * std::numbers::pi * lot()});
        }
    }

    // Where the waves take the point that is at (x, z) in a calm sea, and `width`, which tells how
    // much they squeeze the surface there: 1 in a calm sea, less on crests.
    struct Point {
        Vec3 at;
        double width;
    };
    Point point(double x, double z) const {
        // The great wave comes from behind, on the left.
        const double from_crest = (z + 8 + 0.5 * x) / 3, beside = (x + 8) / 7;
        const double great = 5.2 * rt::portable::exp(-from_crest * from_crest - beside * beside);
        double px = x + 0.30 * great, py = great - 0.25, pz = z + 0.55 * great;
        double slope_xx = 0.13 * great, slope_zz = 0;
        for (const Wave& wave : waves_) {
            const double phase = wave.x * x + wave.z * z + wave.start;
            const double sine = rt::portable::sin(phase), cosine = rt::portable::cos(phase);
            py += wave.height * cosine;
            px -= 0.85 * wave.height * wave.along_x * sine;
            pz -= 0.85 * wave.height * wave.along_z * sine;
            slope_xx += 0.85 * wave.height * wave.along_x * wave.x * cosine;
            slope_zz += 0.85 * wave.height * wave.along_z * wave.z * cosine;
        }
        return {{static_cast<Real>(px), static_cast<Real>(py), static_cast<Real>(pz)},
                (1 - slope_xx) * (1 - slope_zz)};
    }

  private:
    struct Wave {
        double x, z;              // radians per unit of length
        double along_x, along_z;  // its direction
        double height, start;
    };
    std::vector<Wave> waves_;
};

// The sea around the picture's middle, as two meshes, water and foam, with about `count` triangles
// in all: n x n squares, which grow with their distance from the camera; and as facets, on the
// right of the cut as far as one can tell them apart.
struct SeaMeshes {
    Mesh water, foam;
    Facets facets;
};
inline SeaMeshes make_sea(int count, const Cut& cut) {
    const int n = std::max(2, static_cast<int>(std::sqrt(count / 2.0)));
    const Sea sea;
    SeaMeshes meshes;
    std::vector<double> widths;
    for (int row = 0; row <= n; ++row) {
        const double back = static_cast<double>(row) / n;
        const double distance = 3.5 * rt::portable::exp(3.9 * back), z = 12 - distance;
        for (int column = 0; column <= n; ++column) {
            const double side = 2.0 * column / n - 1;
            const auto [at, width] = sea.point(0.3 + side * (4 + 0.75 * distance), z);
            meshes.water.points.push_back(at);
            widths.push_back(width);
        }
    }
    meshes.foam.points = meshes.water.points;
    const auto corner = [&](int row, int column) { return Corner{row * (n + 1) + column}; };
    const auto add = [&](const Corner& a, const Corner& b, const Corner& c) {
        const auto squeezed = [&](const Corner& at) {
            return widths[static_cast<std::size_t>(at.point)] < 0.42;
        };
        (squeezed(a) && squeezed(b) && squeezed(c) ? meshes.foam : meshes.water)
            .triangles.push_back({a, b, c});
    };
    // The sea is made block by block.
    const int size = std::max(1, n / 56);
    for (int top = 0; top < n; top += size)
        for (int left = 0; left < n; left += size) {
            const int bottom = std::min(n, top + size), right = std::min(n, left + size);
            const Vec3 at = meshes.water.points[static_cast<std::size_t>(corner(top, left).point)];
            if (cut.is_right_of(at) && at.z > Real(-10)) {
                meshes.facets.add(meshes.water,
                                  {corner(top, left), corner(top, right), corner(bottom, left)});
                meshes.facets.add(meshes.water, {corner(top, right), corner(bottom, right),
                                                 corner(bottom, left)});
                continue;
            }
            for (int row = top; row < bottom; ++row)
                for (int column = left; column < right; ++column) {
                    add(corner(row, column), corner(row, column + 1), corner(row + 1, column));
                    add(corner(row, column + 1), corner(row + 1, column + 1),
                        corner(row + 1, column));
                }
        }
    add_normals(meshes.water);
    add_normals(meshes.foam);
    return meshes;
}

// The painting on the pot: rows of arcs, the Japanese wave pattern seigaiha.
inline Image make_glaze() {
    constexpr int width = 1024, height = 512;
    constexpr double across = 64;  // the width of an arc, in pixels
    return make_image(width, height, [](int x, int y) {
        const Color white = from_hex(0xf3ead8), blue = from_hex(0x1b3f77);
        // Where arcs overlap, the arc of the lowest row is in front.
        double ring = 1;
        for (int row = static_cast<int>(y / (across / 4)) - 4; row < height; ++row) {
            const double cy = row * across / 4 + across / 2;
            if (cy - across / 2 > y) break;
            const double shift = row % 2 ? across / 2 : 0;
            const double column = std::floor((x - shift) / across + 0.5);
            const double dx = x - shift - column * across, dy = y - cy;
            const double distance = std::sqrt(dx * dx + dy * dy) / (across / 2);
            if (distance < 1) ring = distance;
        }
        const int stripe = static_cast<int>(ring * 6.999);
        return stripe % 2 ? white : blue;
    });
}

struct Scene {
    SceneDescription description;
    SceneMeshes meshes;
};

// The scene, with about `count` triangles in all.
inline Scene make_scene(int count, const View& view) {
    Scene scene;
    SceneDescription& description = scene.description;
    description.camera = {view, {Real(0.06), Real(12)}, 0};
    description.sky = {{Real(1.35), Real(0.72), Real(0.42)}, {Real(0.10), Real(0.24), Real(0.55)}};
    description.images.push_back(make_glaze());
    enum { water, foam, glaze, gold, sun, lamp, deep, blue, wire };
    description.materials = {Dielectric{Real(1.33)},
                             Lambertian{{Real(0.9), Real(0.9), Real(0.88)}},
                             PictureMatte{0},
                             Metal{from_hex(0xffc46b), Real(0.12)},
                             Emitter{{Real(2.6), Real(0.62), Real(0.16)}},
                             Emitter{{Real(3.4), Real(2.9), Real(2.3)}},
                             Lambertian{{Real(0.012), Real(0.10), Real(0.13)}},
                             Lambertian{from_hex(0x1b3f77)},
                             Lambertian{{Real(0.85), Real(0.8), Real(0.7)}}};
    description.spheres.push_back({{{74, 9, -160}, 12}, sun, {}});
    description.spheres.push_back({{{-45, 50, 50}, 28}, lamp, {}});  // behind us, on the left
    description.spheres.push_back({{{0, -3004, 0}, 3000}, deep, {}});

    const Cut cut{scene_view().from, {Real(3.8), Real(5), 0}, {Real(0.1), Real(-2.2), 0}};
    const SeaMeshes sea = make_sea(count - 40'000, cut);
    scene.meshes.add(sea.water, {}, water);
    scene.meshes.add(sea.foam, {}, foam);
    scene.meshes.add(sea.facets.faces, {}, water);
    scene.meshes.add(sea.facets.wires, {}, wire);
    const Mat4 afloat =
        multiply(translation({Real(1.0), Real(-0.62), Real(0.6)}),
                 multiply(rotation_y(radians(-28)),
                          multiply(rotation_z(radians(13)), rotation_x(radians(-9)))));
    for (const TeapotParts& parts : {teapot_body, teapot_handle_and_spout}) {
        const CutPart part = cut_part(parts, afloat, cut);
        const bool is_body = parts.first == teapot_body.first;
        scene.meshes.add(part.smooth, afloat, is_body ? glaze : gold);
        scene.meshes.add(part.facets.faces, afloat, is_body ? blue : gold);
        scene.meshes.add(part.facets.wires, afloat, wire);
    }
    for (const TeapotParts& parts : {teapot_lid, teapot_bottom})
        scene.meshes.add(make_teapot(24, parts), afloat, gold);
    return scene;
}

// The triangle that 12.1 draws.
inline constexpr Triangle single_triangle{
    {Real(-3), Real(-0.4), 0}, {Real(3), Real(-0.4), 0}, {Real(1), Real(3.8), 0}};

// A golden teapot of some 550 triangles, on matte ground; flat, or with smooth normals.
inline Scene make_pot(bool is_smooth, const View& view) {
    Scene scene;
    SceneDescription& description = scene.description;
    description.camera = {view, {}, 0};
    description.sky = {{Real(1.35), Real(0.72), Real(0.42)}, {Real(0.10), Real(0.24), Real(0.55)}};
    enum { ground, gold };
    description.materials = {Lambertian{{Real(0.5), Real(0.55), Real(0.55)}},
                             Metal{from_hex(0xffc46b), Real(0.03)}};
    description.spheres.push_back({{{0, -1000, 0}, 1000}, ground, {}});
    Mesh pot = make_teapot(3);
    if (!is_smooth)
        for (auto& triangle : pot.triangles)
            for (Corner& corner : triangle) corner.normal = -1;
    scene.meshes.add(pot, translation({Real(-0.3), 0, Real(4)}), gold);
    return scene;
}

// A ball of clay under a small lamp: a sphere, or a mesh of 20 * 4^cuts triangles with smooth
// normals.
inline Scene make_clay_ball(bool is_mesh, const View& view, int cuts = 2) {
    Scene scene;
    SceneDescription& description = scene.description;
    description.camera = {view, {}, 0};
    description.sky = {{Real(0.008), Real(0.010), Real(0.014)},
                       {Real(0.012), Real(0.016), Real(0.024)}};
    enum { clay, lamp };
    description.materials = {Lambertian{from_hex(0xd9a27e)}, Emitter{{1400, 1400, 1400}}};
    description.spheres.push_back({{{45, 30, -6}, 2}, lamp, {}});
    const Vec3 center{Real(0.15), Real(1.45), 0};
    constexpr Real radius = Real(3);
    if (is_mesh) {
        Mesh ball = make_ball(cuts);
        for (Vec3& point : ball.points) point = radius * point;
        scene.meshes.add(ball, translation(center), clay);
    } else {
        description.spheres.push_back({{center, radius}, clay, {}});
    }
    return scene;
}

}  // namespace triangles
