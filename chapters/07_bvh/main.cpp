// Chapter 07: ten thousand spheres, the boxes that they are sorted into, and how much work each
// pixel takes with the linear list, with the sorted tree and with the tree by surface area.

#include <app/run.hpp>
#include <rt/area_split.hpp>
#include <rt/canvas.hpp>
#include <rt/counting_world.hpp>
#include <rt/fill.hpp>
#include <rt/render_pixel.hpp>
#include <rt/show_paths.hpp>

#include "scene.hpp"
#include "tree_figure.hpp"

namespace {

using namespace bvh;

// The boxes around all spheres, filled with light: the longer a ray is in them, the brighter.
app::Picture show_boxes(const app::Settings& settings, app::Progress& progress,
                        const Scene& scene) {
    const std::vector<Box> boxes = bounds_of(scene.spheres);
    const Camera camera = make_camera(*settings.view, settings.width, settings.height);
    return {app::draw<Canvas<Color>>(settings, progress, [&](int x, int y) {
        const SlabRay ray = slab_ray(ray_through(camera, x, y));
        Color light = paper;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const Interval part = hit_box(boxes[i], ray, Interval{0, infinity});
            const auto material = static_cast<std::size_t>(scene.spheres[i].material);
            if (part.min <= part.max)
                light += 4 * (part.max - part.min) * scene.materials.materials[material].albedo;
        }
        return light;
    })};
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    // The seed that was asked for changes only the noise: the scene stays the same.
    const Scene scene = make_scene(10'000, 1);
    if (settings.show == "boxes") return show_boxes(settings, progress, scene);
    const SphereTree sorted = make_tree(scene.spheres, split_in_half);
    const SphereTree by_area = make_tree(scene.spheres, AreaSplit{});
    if (!settings.show.empty())
        return show_paths(settings, progress, by_area, scene.materials, StudioSky{}, SkyEnding{});

    Image image = Canvas<Color>{settings.width, settings.height, paper};
    Figure figure{image, figure_width, figure_height};
    Figure view = figure.part(picture);
    progress.start(view.rows() + static_cast<int>(levels.size() + maps.size()));

    std::uint64_t rays = 0;
    const CountingWorld<SphereTree> world{by_area, rays};
    const Camera camera = camera_of(view, *settings.view);
    const Quality quality{settings.spp, settings.depth, *settings.seed};
    app::fill(
        view,
        [&](int x, int y) {
            return render_pixel(camera, world, scene.materials, StudioSky{}, SkyEnding{}, quality,
                                x, y);
        },
        &progress);

    constexpr std::array<int, 4> shown{1, 3, 5, 8};
    const Color colors[] = {from_hex(0x8ecae6), from_hex(0xffd166), from_hex(0xef8354),
                            from_hex(0xc77dff)};
    for (std::size_t i = 0; i < shown.size(); ++i) {
        draw_level(figure, levels[i], scene, sorted, shown[i], colors[i],
                   Real(0.9) / static_cast<Real>(1 + i));
        progress.step();
    }

    const auto draw_map = [&](std::size_t i, const char* name, auto tests) {
        draw_heat_map(figure, maps[i], name, tests, *settings.view);
        progress.step();
    };
    const auto tests_in = [&](const SphereTree& tree, const Ray& ray) {
        ++rays;
        const Search search = tree.search(ray, {});
        return static_cast<Real>(search.box_tests + search.shape_tests);
    };
    // The list tests every sphere for every ray, so this count needs no ray.
    const auto all = static_cast<Real>(scene.spheres.size());
    draw_map(0, "Linear list", [&](const Ray&) { return all; });
    write_in_map(figure, maps[0], "10,000 tests", "in every pixel");
    draw_map(1, "Sorted tree", [&](const Ray& ray) { return tests_in(sorted, ray); });
    draw_map(2, "Tree by area", [&](const Ray& ray) { return tests_in(by_area, ray); });
    draw_legend(figure);
    return {std::move(image), rays};
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> shows = shown_of_paths();
    shows.push_back("boxes");
    app::Settings defaults;
    defaults.width = 980;
    defaults.height = 700;
    defaults.spp = 25;
    defaults.depth = 6;
    defaults.seed = 1;
    defaults.view = scene_view();
    return app::run(argc, argv,
                    {.name = "07_bvh",
                     .about = "10,000 spheres, the boxes of their tree, and the work of each pixel",
                     .defaults = defaults,
                     .render = render,
                     .study = app::program_study,
                     .shows = shows});
}
