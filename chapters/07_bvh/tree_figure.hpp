#pragma once
// The panels beside the scene: the boxes of the tree's levels, and maps of the work of each pixel.

#include <app/figure.hpp>
#include <array>
#include <rt/false_colors.hpp>
#include <rt/make_camera.hpp>
#include <rt/portable.hpp>
#include <rt/primary_ray.hpp>
#include <rt/shape_tree.hpp>
#include <string>

#include "scene.hpp"

namespace bvh {

using app::Figure;

inline const Color paper = from_hex(0x12141c), ink = from_hex(0xe8e4da);

// Where everything is, in the figure's own units: the picture on the left, the boxes beside it, the
// heat maps below.
constexpr Real figure_width = 980, figure_height = 700, letter_height = Real(11.3);
constexpr app::Box picture{7, 7, 571, 403}, legend{7, 659, 966, 34};
constexpr std::array<app::Box, 4> levels{
    {{585, 7, 190, 198}, {782, 7, 190, 198}, {585, 212, 190, 198}, {782, 212, 190, 198}}};
constexpr std::array<app::Box, 3> maps{
    {{7, 417, 317, 235}, {331, 417, 317, 235}, {655, 417, 317, 235}}};

inline Camera camera_of(const Figure& panel, View view) {
    // A narrow panel shows as much of the scene from side to side as a wide one.
    const Real aspect = static_cast<Real>(panel.columns()) / static_cast<Real>(panel.rows());
    if (aspect < Real(1.5))
        view.vertical_fov =
            2 * rt::portable::atan(rt::portable::tan(view.vertical_fov / 2) * Real(1.5) / aspect);
    return make_camera(view, panel.columns(), panel.rows());
}

inline Ray ray_through(const Camera& camera, int x, int y) {
    return primary_ray(camera, x, y, {Real(0.5), Real(0.5)});
}

// Boxes reach farther than their spheres, most of all on the left, where they are near the camera.
// So the camera is a little farther away and to the left.
inline View boxes_view() {
    View view = scene_view();
    view.at.x -= Real(0.6);
    view.from.x -= Real(0.6);
    view.from = view.at + Real(1.18) * (view.from - view.at);
    return view;
}

// Where a point is seen in a panel, in the panel's units.
inline Vec2 project(const Camera& camera, Vec3 point, const app::Box& panel) {
    const Vec3 to = point - camera.eye;
    const Real depth = -dot(to, camera.basis.w);
    const Real x = dot(to, camera.basis.u) / depth / camera.viewport.width + Real(0.5);
    const Real y = Real(0.5) - dot(to, camera.basis.v) / depth / camera.viewport.height;
    return {x * panel.width, y * panel.height};
}

// Calls draw(a, b) for the twelve edges of a box.
template <class Draw>
void for_each_edge(const Box& box, Draw draw) {
    const auto corner = [&](int i) {
        return Vec3{i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                    i & 4 ? box.high.z : box.low.z};
    };
    for (int i = 0; i < 8; ++i)
        for (const int bit : {1, 2, 4})
            if (!(i & bit)) draw(corner(i), corner(i | bit));
}

// Calls visit(box) for the nodes of one level. A leaf above that level stands for the nodes that
// would be below it.
template <class Visit>
void for_each_box(const TreeNode& node, int level, Visit visit) {
    if (level == 0 || node.is_leaf()) return visit(node.box);
    for_each_box(*node.left, level - 1, visit);
    for_each_box(*node.right, level - 1, visit);
}

// Draws the boxes of one level of a tree. The spheres are drawn, too, but faintly.
inline void draw_level(const Figure& figure, const app::Box& where, const Scene& scene,
                       const SphereTree& tree, int level, Color color, Real share) {
    Figure panel = figure.part(where);
    const Camera camera = camera_of(panel, boxes_view());
    panel.fill([&](int x, int y) {
        const auto hit = tree.hit(ray_through(camera, x, y), {});
        if (!hit) return from_hex(0x1a1d29);
        const Color albedo =
            scene.materials.materials[static_cast<std::size_t>(hit->material)].albedo;
        return Real(0.16) * (hit->normal.y + Real(1.2)) * albedo;
    });
    for_each_box(*tree.root, level, [&](const Box& box) {
        for_each_edge(box, [&](Vec3 a, Vec3 b) {
            panel.line(project(camera, a, where), project(camera, b, where), color, 1, share);
        });
    });
    panel.words({letter_height / 2, letter_height / 2}, "Level " + std::to_string(level),
                {letter_height, color});
}

// The position on the color scale for this many tests: 0 for 1 test, 1 for 10,000 tests; each
// factor of ten adds a quarter.
inline Real heat(Real tests) {
    return rt::portable::log10(std::max(Real(1), tests)) / 4;
}

// Draws how many tests the ray of each pixel takes, which tests(ray) returns. The average stands in
// the map's upper left corner, on a dark plate, so that it can be read on any background.
template <class Tests>
void draw_heat_map(const Figure& figure, const app::Box& where, const std::string& name,
                   Tests tests, const View& view) {
    Figure panel = figure.part(where);
    const Camera camera = camera_of(panel, view);
    double sum = 0;
    panel.fill([&](int x, int y) {
        const Real count = tests(ray_through(camera, x, y));
        sum += static_cast<double>(count);
        return heat_color(heat(count));
    });
    const auto mean = static_cast<long>(sum / (double(panel.columns()) * panel.rows()));
    const std::string words = name + "  " + std::to_string(mean);
    panel.box({0, 0, app::width_of(words, letter_height) + letter_height, 2 * letter_height},
              paper);
    panel.words({letter_height / 2, letter_height / 2}, words, {letter_height, ink});
}

// Writes two lines in the middle of a bright map.
inline void write_in_map(const Figure& figure, const app::Box& where, const char* above,
                         const char* below) {
    Figure panel = figure.part(where);
    panel.words_around({where.width / 2, where.height / 2 - 11}, above, {14, paper});
    panel.words_around({where.width / 2, where.height / 2 + 15}, below, {14, paper});
}

// Draws the scale of the heat maps, marked at the powers of ten.
inline void draw_legend(const Figure& figure) {
    Figure panel = figure.part(legend);
    panel.words({letter_height / 8, letter_height / 4}, "Tests per pixel", {letter_height, ink});
    const app::Box bar{legend.left + 161, legend.top, 736, 11};
    Figure scale = figure.part(bar);
    scale.fill([&](int x, int) {
        return heat_color(static_cast<Real>(x) / static_cast<Real>(scale.columns()));
    });
    int tests = 1;
    for (int tenfold = 0; tenfold <= 4; ++tenfold, tests *= 10)
        panel.words({161 + bar.width * static_cast<Real>(tenfold) / 4, 17}, std::to_string(tests),
                    {9, ink});
}

}  // namespace bvh
