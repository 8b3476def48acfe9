#pragma once
// The panels of the picture: where they are, and how each is drawn.

#include <app/run.hpp>
#include <array>
#include <rt/counting_world.hpp>
#include <rt/render_pixel.hpp>
#include <rt/sphere_tree.hpp>
#include <rt/split_by_area.hpp>
#include <string>

#include "scene.hpp"
#include "sheet.hpp"

namespace bvh {

// The picture on the left, the boxes beside it, the heat maps below.
struct Layout {
    Panel picture;
    std::array<Panel, 4> levels;
    std::array<Panel, 3> maps;
    Panel legend;
    Real letters;  // their height

    Layout(int width, int height) {
        const int gap = std::max(1, std::min(width, height) / 90);
        letters = static_cast<Real>(std::min(width, height)) / 62;
        const int row = (height - 4 * gap) * 6 / 10, below = (height - 4 * gap) * 35 / 100;
        const int column = (width - 4 * gap) * 60 / 100;
        picture = {gap, gap, column, row};
        const int left = 2 * gap + column;
        const int w = (width - left - 2 * gap) / 2, h = (row - gap) / 2;
        for (int i = 0; i < 4; ++i)
            levels[static_cast<std::size_t>(i)] = {left + i % 2 * (w + gap),
                                                   gap + i / 2 * (h + gap), w, h};
        const int third = (width - 4 * gap) / 3;
        for (int i = 0; i < 3; ++i)
            maps[static_cast<std::size_t>(i)] = {gap + i * (third + gap), row + 2 * gap, third,
                                                 below};
        legend = {gap, row + below + 3 * gap, width - 2 * gap, height - row - below - 4 * gap};
    }
};

inline Camera camera_of(const Panel& panel, View view = scene_view()) {
    const int width = std::max(1, panel.width), height = std::max(1, panel.height);
    // Narrow panels see as much from side to side as wide ones.
    const Real aspect = static_cast<Real>(width) / static_cast<Real>(height);
    if (aspect < Real(1.5))
        view.vertical_fov = 2 * std::atan(std::tan(view.vertical_fov / 2) * Real(1.5) / aspect);
    return make_camera(view, width, height);
}

// Boxes reach farther than their spheres, most of all on the left, where they are near: seen from a
// little farther away and to the left.
inline View boxes_view() {
    View view = scene_view();
    view.at.x -= Real(0.6);
    view.from.x -= Real(0.6);
    view.from = view.at + Real(1.18) * (view.from - view.at);
    return view;
}

inline void draw_level(Image& image, const Panel& panel, const Camera& camera, const TreeNode& node,
                       int level, Color color, Real share) {
    // Leaves above the level stand for what would be below them.
    if (level == 0 || node.is_leaf()) {
        draw_box(image, panel, camera, node.box, color, share);
        return;
    }
    draw_level(image, panel, camera, *node.left, level - 1, color, share);
    draw_level(image, panel, camera, *node.right, level - 1, color, share);
}

// The scene, and the trees that its spheres are sorted into.
struct Forest {
    Scene scene;
    SphereTree sorted = make_tree(scene.spheres, split_in_half);
    SphereTree by_area = make_tree(scene.spheres, split_by_area);
};

// Calls shade(column, row) for the pixels of a panel that lie on the sheet.
template <class Shade>
void fill(Image& image, const Panel& panel, Shade shade) {
    for (int y = 0; y < panel.height; ++y)
        for (int x = 0; x < panel.width; ++x)
            if (panel.left + x < image.width() && panel.top + y < image.height())
                image.at(panel.left + x, panel.top + y) = shade(x, y);
}

// The scene itself. Steps the progress with each row, and counts the rays.
inline void draw_scene(Image& image, const Panel& panel, const Forest& forest,
                       const Quality& quality, std::uint64_t& rays, app::Progress& progress) {
    const Camera camera = camera_of(panel);
    const CountingWorld<SphereTree> world{forest.by_area, rays};
    fill(image, panel, [&](int x, int y) {
        if (x == panel.width - 1) progress.step();
        return render_pixel(camera, world, forest.scene.materials, StudioSky{}, SkyEnding{},
                            quality, x, y);
    });
}

// The boxes of one level of the tree by area. The spheres are there, but faint.
inline void draw_boxes(Image& image, const Panel& panel, const Forest& forest, int level,
                       Color color, Real share, Real letters, std::uint64_t& rays) {
    const Camera eye = camera_of(panel, boxes_view());
    fill(image, panel, [&](int x, int y) {
        const auto hit = forest.by_area.hit(primary_ray(eye, x, y, {Real(0.5), Real(0.5)}), {});
        ++rays;
        if (!hit) return from_hex(0x1a1d29);
        const Color albedo =
            forest.scene.materials.materials[static_cast<std::size_t>(hit->material)].albedo;
        return Real(0.16) * (hit->normal.y + Real(1.2)) * albedo;
    });
    draw_level(image, panel, eye, *forest.by_area.root, level, color, share);
    write(image, "LEVEL " + std::to_string(level), static_cast<Real>(panel.left) + letters / 2,
          static_cast<Real>(panel.top) + letters / 2, letters, color);
}

// How many tests the ray of each pixel takes: tests(ray) says it.
template <class Tests>
void draw_heat_map(Image& image, const Panel& panel, const std::string& name, Tests tests,
                   Real letters) {
    const Camera eye = camera_of(panel);
    double sum = 0;
    fill(image, panel, [&](int x, int y) {
        const Real count = tests(primary_ray(eye, x, y, {Real(0.5), Real(0.5)}));
        sum += static_cast<double>(count);
        return heat_color(heat(count));
    });
    const auto mean = static_cast<long>(sum / std::max(1.0, double(panel.width) * panel.height));
    write_on_plate(image, name + "  " + std::to_string(mean),
                   static_cast<Real>(panel.left) + letters / 2,
                   static_cast<Real>(panel.top) + letters / 2, letters);
}

// The scale of the heat maps, with its tenfolds.
inline void draw_legend(Image& image, const Panel& panel, Real letters) {
    write(image, "TESTS A PIXEL", static_cast<Real>(panel.left),
          static_cast<Real>(panel.top) + letters / 4, letters);
    const int start = panel.width / 6, end = panel.width - panel.width / 14;
    const int bar = std::max(1, panel.height / 3);
    for (int x = start; x < end; ++x)
        for (int y = 0; y < bar; ++y)
            blend(image, panel.left + x, panel.top + y,
                  heat_color(static_cast<Real>(x - start) / static_cast<Real>(end - start)), 1);
    int tests = 1;
    for (int tenfold = 0; tenfold <= 4; ++tenfold, tests *= 10)
        write(image, std::to_string(tests),
              static_cast<Real>(panel.left + start + (end - start) * tenfold / 4),
              static_cast<Real>(panel.top + bar) + letters / 2, letters * Real(0.8));
}

}  // namespace bvh
