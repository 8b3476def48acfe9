#pragma once
// The scenes of chapter 14: the Cornell box, and points spread over a triangle.

#include <algorithm>
#include <array>
#include <rt/image.hpp>
#include <rt/lit_mesh_scene.hpp>
#include <rt/rng.hpp>

#include "cornell_spectra.hpp"

namespace light {

using namespace rt;

// The effects that the scenes call for.
inline constexpr Effects scene_effects{.lights = true};

// The camera of the measured box: 35 mm of focal length, and film of 25 x 25 mm.
inline View cornell_view() {
    View view;
    view.from = {278, 273, -800};
    view.at = {278, 273, 0};
    view.vertical_fov = radians(Real(39.3077));  // 2 atan(12.5 / 35)
    return view;
}

struct Scene {
    SceneDescription description;
    SceneMeshes meshes;
};

// Adds a polygon with four corners to a mesh, as two triangles.
using Four = std::array<Vec3, 4>;
inline void add_four(Mesh& mesh, const Four& corners) {
    const auto first = static_cast<int>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
    mesh.triangles.push_back({Corner{first}, Corner{first + 1}, Corner{first + 2}});
    mesh.triangles.push_back({Corner{first}, Corner{first + 2}, Corner{first + 3}});
}

// The box of Cornell University, in millimeters, as it stood there: x leads to the left as the
// camera sees it. Its ceiling has a hole, which the lamp fills.
// Source: as in cornell_spectra.hpp; Goral, Torrance, Greenberg and Battaile, "Modeling the
// interaction of light between diffuse surfaces", SIGGRAPH 1984.
inline Scene make_cornell(const View& view) {
    Scene scene;
    SceneDescription& description = scene.description;
    description.camera = {view, {}, 0};
    description.sky = {};
    enum { white, green, red, lamp };
    description.materials = {
        Lambertian{paint_color(white_paint)}, Lambertian{paint_color(green_paint)},
        Lambertian{paint_color(red_paint)}, Emitter{Real(2.5) * balanced_lamp()}};

    const auto add = [&](int material, const Four& corners) {
        Mesh mesh;
        add_four(mesh, corners);
        scene.meshes.add(mesh, Mat4{}, material);
    };
    const Real high = Real(548.8), deep = Real(559.2);
    const Four ceiling{{{556, high, 0}, {556, high, deep}, {0, high, deep}, {0, high, 0}}};
    const Four hole{{{343, high, 227}, {343, high, 332}, {213, high, 332}, {213, high, 227}}};
    add(lamp, hole);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        add(white, {ceiling[i], ceiling[next], hole[next], hole[i]});
    }
    add(white, {{{Real(552.8), 0, 0}, {0, 0, 0}, {0, 0, deep}, {Real(549.6), 0, deep}}});
    add(white,
        {{{Real(549.6), 0, deep}, {0, 0, deep}, {0, high, deep}, {556, high, deep}}});  // back
    add(green, {{{0, 0, deep}, {0, 0, 0}, {0, high, 0}, {0, high, deep}}});
    add(red, {{{Real(552.8), 0, 0}, {Real(549.6), 0, deep}, {556, high, deep}, {556, high, 0}}});
    const auto add_block = [&](const Four& top) {
        add(white, top);
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3 a = top[i], b = top[(i + 1) % 4];
            add(white, {{a, {a.x, 0, a.z}, {b.x, 0, b.z}, b}});
        }
    };
    add_block({{{130, 165, 65}, {82, 165, 225}, {240, 165, 272}, {290, 165, 114}}});
    add_block({{{423, 330, 247}, {265, 330, 296}, {314, 330, 456}, {472, 330, 406}}});
    return scene;
}

// The same box at a party: three strings of small colored lamps, each an octahedron.
inline Scene make_party(const View& view) {
    Scene scene = make_cornell(view);
    const auto first = static_cast<int>(scene.description.materials.size());
    for (const unsigned color : {0xffb347u, 0xff5e8au, 0x56b4ffu, 0x9be564u})
        scene.description.materials.push_back(Emitter{Real(4) * from_hex(color)});
    Mesh lamp;
    lamp.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const int x : {0, 1})
        for (const int y : {2, 3})
            for (const int z : {4, 5}) {
                const bool turned = (x + y + z) % 2 == 1;  // seen from outside: counterclockwise
                lamp.triangles.push_back(
                    {Corner{x}, Corner{turned ? z : y}, Corner{turned ? y : z}});
            }
    int number = 0;
    for (const Real z : {Real(140), Real(260), Real(470)})
        for (int i = 0; i < 30; ++i) {
            const Real along = (static_cast<Real>(i) + Real(0.5)) / 30, from_middle = 2 * along - 1;
            const Vec3 at{Real(6) + Real(540) * along,
                          Real(330) + Real(0.15) * z + Real(110) * from_middle * from_middle, z};
            const Real size = 6;
            scene.meshes.add(lamp, from_columns({size, 0, 0}, {0, size, 0}, {0, 0, size}, at),
                             first + number++ % 4);
        }
    return scene;
}

// 3000 points that even_weights spreads over a triangle, each a dot; its color says by which sample
// point it was chosen.
inline Image make_points(int width, int height) {
    const Color paper = from_hex(0xf7f4ec);
    Image image{width, height, paper};
    const Real w = static_cast<Real>(width), h = static_cast<Real>(height);
    const Vec2 a{Real(0.06) * w, Real(0.92) * h}, b{Real(0.94) * w, Real(0.72) * h},
        c{Real(0.38) * w, Real(0.06) * h};
    const Real radius = std::max(Real(0.6), h / 220);
    Rng random{14, 1};
    for (int i = 0; i < 3000; ++i) {
        const Vec2 place = random_place(random), weight = even_weights(place);
        const Real of_a = 1 - weight.x - weight.y;
        const Vec2 at{of_a * a.x + weight.x * b.x + weight.y * c.x,
                      of_a * a.y + weight.x * b.y + weight.y * c.y};
        const Color dot =
            rt::mix(rt::mix(from_hex(0xe4572e), from_hex(0xf3a712), place.y),
                    rt::mix(from_hex(0x1d6996), from_hex(0x38a6a5), place.y), place.x);
        const auto first = [](Real from, int end) {
            return static_cast<int>(std::clamp(from, Real(0), static_cast<Real>(end)));
        };
        for (int y = first(at.y - radius, height); y < first(at.y + radius + 1, height); ++y)
            for (int x = first(at.x - radius, width); x < first(at.x + radius + 1, width); ++x) {
                const Real dx = static_cast<Real>(x) + Real(0.5) - at.x,
                           dy = static_cast<Real>(y) + Real(0.5) - at.y;
                if (dx * dx + dy * dy <= radius * radius) image.at(x, y) = dot;
            }
    }
    return image;
}

}  // namespace light
