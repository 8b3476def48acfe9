#pragma once
// The scene of chapter 12: a teapot afloat on a stormy sea of a million triangles.

#include <algorithm>
#include <numbers>
#include <rt/make_teapot.hpp>
#include <rt/mesh_world.hpp>
#include <rt/portable.hpp>
#include <rt/rng.hpp>
#include <rt/scene.hpp>

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
// in all: n x n squares, which grow with their distance from the camera.
struct SeaMeshes {
    Mesh water, foam;
};
inline SeaMeshes make_sea(int count) {
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
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            add(corner(row, column), corner(row, column + 1), corner(row + 1, column));
            add(corner(row, column + 1), corner(row + 1, column + 1), corner(row + 1, column));
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
    enum { water, foam, glaze, gold, sun, lamp, deep };
    description.materials = {Dielectric{Real(1.33)},
                             Lambertian{{Real(0.9), Real(0.9), Real(0.88)}},
                             PictureMatte{0},
                             Metal{from_hex(0xffc46b), Real(0.12)},
                             Emitter{{Real(2.6), Real(0.62), Real(0.16)}},
                             Emitter{{Real(34), Real(29), Real(23)}},
                             Lambertian{{Real(0.012), Real(0.10), Real(0.13)}}};
    description.spheres.push_back({{{37, 19, -160}, 23}, sun, {}});
    description.spheres.push_back({{{-45, 50, 50}, 9}, lamp, {}});  // behind us, on the left
    description.spheres.push_back({{{0, -3004, 0}, 3000}, deep, {}});

    const SeaMeshes sea = make_sea(count - 40'000);
    scene.meshes.add(sea.water, {}, water);
    scene.meshes.add(sea.foam, {}, foam);
    const Mat4 afloat =
        multiply(translation({Real(1.0), Real(-0.62), Real(0.6)}),
                 multiply(rotation_y(radians(-28)),
                          multiply(rotation_z(radians(13)), rotation_x(radians(-9)))));
    scene.meshes.add(make_teapot(24, teapot_body), afloat, glaze);
    for (const TeapotParts& parts : {teapot_lid, teapot_bottom, teapot_handle_and_spout})
        scene.meshes.add(make_teapot(24, parts), afloat, gold);
    return scene;
}

}  // namespace triangles
