// Chapter 07: ten thousand spheres, the boxes that they are sorted into, and how much work each
// pixel is for the linear list, for the sorted tree and for the tree by surface area.

#include <app/run.hpp>
#include <rt/counting_world.hpp>
#include <rt/render_pixel.hpp>
#include <rt/sphere_tree.hpp>
#include <rt/split_by_area.hpp>
#include <string>

#include "scene.hpp"
#include "sheet.hpp"
#include "study.hpp"

namespace {

using namespace bvh;

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

Camera camera_of(const Panel& panel, View view = scene_view()) {
    const int width = std::max(1, panel.width), height = std::max(1, panel.height);
    // Narrow panels see as much from side to side as wide ones.
    const Real aspect = static_cast<Real>(width) / static_cast<Real>(height);
    if (aspect < Real(1.5))
        view.vertical_fov = 2 * std::atan(std::tan(view.vertical_fov / 2) * Real(1.5) / aspect);
    return make_camera(view, width, height);
}

// Boxes reach farther than their spheres, most of all on the left, where they are near: seen from a
// little farther away and to the left.
View boxes_view() {
    View view = scene_view();
    view.at.x -= Real(0.6);
    view.from.x -= Real(0.6);
    view.from = view.at + Real(1.18) * (view.from - view.at);
    return view;
}

void draw_level(Image& image, const Panel& panel, const Camera& camera, const TreeNode& node,
                int level, Color color, Real share) {
    // Leaves above the level stand for what would be below them.
    if (level == 0 || node.is_leaf()) {
        draw_box(image, panel, camera, node.box, color, share);
        return;
    }
    draw_level(image, panel, camera, *node.left, level - 1, color, share);
    draw_level(image, panel, camera, *node.right, level - 1, color, share);
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    // The seed that was asked for is the light's alone: the scene stays the same.
    const Scene scene = make_scene(10'000, 1);
    const SphereTree sorted = make_tree(scene.spheres, split_in_half);
    const SphereTree by_area = make_tree(scene.spheres, split_by_area);
    const Layout layout{settings.width, settings.height};
    const Quality quality{settings.spp, settings.depth, *settings.seed};
    std::uint64_t rays = 0;
    const CountingWorld<SphereTree> world{by_area, rays};
    Image image{settings.width, settings.height, paper};
    progress.start(layout.picture.height + 4 + 3);

    // Calls shade(column, row) for the pixels of a panel that lie on the sheet.
    const auto fill = [&](const Panel& panel, auto shade) {
        for (int y = 0; y < panel.height; ++y) {
            for (int x = 0; x < panel.width; ++x)
                if (panel.left + x < image.width() && panel.top + y < image.height())
                    image.at(panel.left + x, panel.top + y) = shade(x, y);
            if (&panel == &layout.picture) progress.step();
        }
    };
    const Camera camera = camera_of(layout.picture);
    fill(layout.picture, [&](int x, int y) {
        return render_pixel(camera, world, scene.materials, StudioSky{}, SkyEnding{}, quality, x,
                            y);
    });
    const Real small = layout.letters, step = small / 2;

    constexpr std::array<int, 4> shown{1, 3, 5, 8};
    const Color colors[] = {from_hex(0x8ecae6), from_hex(0xffd166), from_hex(0xef8354),
                            from_hex(0xc77dff)};
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const Panel& panel = layout.levels[i];
        const Camera eye = camera_of(panel, boxes_view());
        // The spheres are there, but faint.
        fill(panel, [&](int x, int y) {
            const auto hit = by_area.hit(primary_ray(eye, x, y, {Real(0.5), Real(0.5)}), {});
            ++rays;
            if (!hit) return from_hex(0x1a1d29);
            const Color color =
                scene.materials.materials[static_cast<std::size_t>(hit->material)].albedo;
            return Real(0.16) * (hit->normal.y + Real(1.2)) * color;
        });
        draw_level(image, panel, eye, *by_area.root, shown[i], colors[i],
                   Real(0.7) / static_cast<Real>(1 + i));
        write(image, "LEVEL " + std::to_string(shown[i]), static_cast<Real>(panel.left) + step,
              static_cast<Real>(panel.top) + step, small, colors[i]);
        progress.step();
    }

    const char* const names[] = {"LINEAR LIST", "SORTED TREE", "TREE BY AREA"};
    for (std::size_t i = 0; i < 3; ++i) {
        const Panel& panel = layout.maps[i];
        const Camera eye = camera_of(panel);
        double sum = 0;
        fill(panel, [&](int x, int y) {
            const Ray ray = primary_ray(eye, x, y, {Real(0.5), Real(0.5)});
            auto tests = static_cast<Real>(scene.spheres.size());
            if (i > 0) {
                const Search search = (i == 1 ? sorted : by_area).search(ray, {});
                tests = static_cast<Real>(search.box_tests + search.sphere_tests);
                ++rays;
            }
            sum += static_cast<double>(tests);
            return heat_color(heat(tests));
        });
        const auto mean =
            static_cast<long>(sum / std::max(1.0, double(panel.width) * panel.height));
        write_on_plate(image, std::string(names[i]) + "  " + std::to_string(mean),
                       static_cast<Real>(panel.left) + step, static_cast<Real>(panel.top) + step,
                       small);
        progress.step();
    }

    // The scale, with its tenfolds.
    const Panel& legend = layout.legend;
    write(image, "TESTS A PIXEL", static_cast<Real>(legend.left),
          static_cast<Real>(legend.top) + step / 2, small);
    const int start = legend.width / 6, end = legend.width - legend.width / 14;
    const int bar = std::max(1, legend.height / 3);
    for (int x = start; x < end; ++x)
        for (int y = 0; y < bar; ++y)
            blend(image, legend.left + x, legend.top + y,
                  heat_color(static_cast<Real>(x - start) / static_cast<Real>(end - start)), 1);
    int tests = 1;
    for (int tenfold = 0; tenfold <= 4; ++tenfold, tests *= 10)
        write(image, std::to_string(tests),
              static_cast<Real>(legend.left + start + (end - start) * tenfold / 4),
              static_cast<Real>(legend.top + bar) + step, small * Real(0.8));
    return {std::move(image), rays};
}

}  // namespace

int main(int argc, char** argv) {
    app::Settings defaults;
    defaults.width = 980;
    defaults.height = 700;
    defaults.spp = 25;
    defaults.depth = 6;
    defaults.seed = 1;
    return app::run(argc, argv,
                    {.name = "07_bvh",
                     .about = "10,000 spheres, the boxes of their tree, and the work of each pixel",
                     .defaults = defaults,
                     .render = render,
                     .study = study_structures});
}
