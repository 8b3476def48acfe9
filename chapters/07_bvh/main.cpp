// Chapter 07: ten thousand spheres, the boxes that they are sorted into, and how much work each
// pixel is for the linear list, for the sorted tree and for the tree by surface area.

#include <app/run.hpp>

#include "panels.hpp"
#include "study.hpp"

namespace {

using namespace bvh;

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    // The seed that was asked for is the light's alone: the scene stays the same.
    const Forest forest{make_scene(10'000, 1)};
    const Layout layout{settings.width, settings.height};
    std::uint64_t rays = 0;
    Image image{settings.width, settings.height, paper};
    progress.start(layout.picture.height + 4 + 3);

    draw_scene(image, layout.picture, forest, {settings.spp, settings.depth, *settings.seed}, rays,
               progress);

    constexpr std::array<int, 4> shown{1, 3, 5, 8};
    const Color colors[] = {from_hex(0x8ecae6), from_hex(0xffd166), from_hex(0xef8354),
                            from_hex(0xc77dff)};
    for (std::size_t i = 0; i < shown.size(); ++i) {
        draw_boxes(image, layout.levels[i], forest, shown[i], colors[i],
                   Real(0.7) / static_cast<Real>(1 + i), layout.letters, rays);
        progress.step();
    }

    const auto draw_map = [&](std::size_t i, const char* name, auto tests) {
        draw_heat_map(image, layout.maps[i], name, tests, layout.letters);
        progress.step();
    };
    const auto tests_in = [&](const SphereTree& tree, const Ray& ray) {
        ++rays;
        const Search search = tree.search(ray, {});
        return static_cast<Real>(search.box_tests + search.sphere_tests);
    };
    // The list tests every sphere for every ray: no ray is needed to know that.
    const auto all = static_cast<Real>(forest.scene.spheres.size());
    draw_map(0, "LINEAR LIST", [&](const Ray&) { return all; });
    draw_map(1, "SORTED TREE", [&](const Ray& ray) { return tests_in(forest.sorted, ray); });
    draw_map(2, "TREE BY AREA", [&](const Ray& ray) { return tests_in(forest.by_area, ray); });
    draw_legend(image, layout.legend, layout.letters);
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
