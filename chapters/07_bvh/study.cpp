// What a ray costs in each structure, how this cost grows with the number of spheres, how long a
// good tree takes to build, and how the time of a whole picture compares with the classic way.

#include <app/run.hpp>
#include <deque>
#include <rt/area_split.hpp>
#include <rt/counting_world.hpp>
#include <rt/far_view.hpp>
#include <rt/flat_tree.hpp>
#include <rt/render_pixel.hpp>
#include <rt/wide_builder.hpp>
#include <study/pixel_error.hpp>
#include <study/report.hpp>
#include <study/timing.hpp>

#include "cover_study.hpp"
#include "other_structures.hpp"
#include "scene.hpp"

namespace bvh {
namespace {

// A picture of a scene, small enough for the slowest world.
struct Shot {
    const Scene& scene;
    int width, height;

    template <class World>
    std::uint64_t render(const World& world) const {
        const Camera camera = make_camera(scene_view(), width, height);
        std::uint64_t rays = 0;
        const CountingWorld<World> counting{world, rays};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                study::keep(render_pixel(camera, counting, scene.materials, StudioSky{},
                                         SkyEnding{}, Quality{1, 4, 1}, x, y));
        return rays;
    }
};

// The average number of tests for a ray. A test of eight boxes or eight spheres at once counts as
// one.
double wide_tests_per_ray(const WideTree& tree, const std::vector<Ray>& rays) {
    double sum = 0;
    for (const Ray& ray : rays) {
        const auto found = tree.search(ray, {});
        sum += found.box_tests + found.shape_tests;
    }
    return sum / static_cast<double>(rays.size());
}

// Times each structure on a picture of the same 10,000 spheres.
void study_searches(study::Report& report, const Scene& scene) {
    const Shot small{scene, 48, 34}, large{scene, 160, 113};
    const SphereList list{scene.spheres};
    const PackedList packed{scene.spheres};
    const SphereTree sorted = make_tree(scene.spheres, split_in_half);
    const SphereTree by_area = make_tree(scene.spheres, AreaSplit{});
    const FlatTree flat = make_flat(by_area);
    const WideTreeOf<SceneSphere, Real> wide = make_wide_tree<Real>(scene.spheres);
    const WideTree wide_float = make_wide_tree<float>(scene.spheres);
    const FlatInOrder in_order{flat};
    std::vector<const char*> names;
    std::vector<double> rays;
    std::vector<study::Work> works;
    const auto add = [&](const char* name, const Shot& shot, const auto& world) {
        names.push_back(name);
        rays.push_back(static_cast<double>(shot.render(world)));
        works.push_back([&] { shot.render(world); });
    };
    add("linear list", small, list);
    add("linear list 8 at once", small, packed);
    add("tree sorted", large, sorted);
    add("tree by area", large, by_area);
    add("flat in order", large, in_order);
    add("flat nearest first", large, flat);
    add("8-wide", large, wide);
    add("8-wide float boxes", large, wide_float);
    const auto ns = study::in_turns_ns(works);
    for (std::size_t i = 0; i < names.size(); ++i)
        report.add({"structures", names[i], 10'000, "spheres", ns[0] / rays[0] * rays[i] / ns[i],
                    "times as fast as the list", ns[i] / rays[i], "time per ray / ns"});
}

// How fast a tree is to search, depending on how long it took to build, on the size of its leaves
// and on what split_by_area takes a box test to cost.
void study_splits(study::Report& report, const Scene& scene) {
    const Shot shot{scene, 120, 85};
    struct Trial {
        std::string study, variant;
        int x;
        SphereTree tree;
    };
    std::deque<Trial> trials;
    std::vector<study::Work> builds, renders;
    const auto add = [&](const char* name, const char* variant, int x, auto split) {
        Trial& trial = trials.emplace_back(Trial{name, variant, x, {}});
        builds.push_back([&trial, &scene, split] { trial.tree = make_tree(scene.spheres, split); });
        renders.push_back([&trial, &shot] { shot.render(trial.tree); });
    };
    add("build", "random axis", 0, SplitRandomAxis{});
    add("build", "sorted", 0, split_in_half);
    add("build", "area binned", 0, split_binned);
    add("build", "area full sweep", 0, AreaSplit{1});
    for (const int size : {1, 2, 4, 8, 16, 32}) add("leaf-size", "sorted", size, SplitLeaf{size});
    for (const int cost : {1, 2, 4, 8, 16})
        add("boxes-cost", "", cost, AreaSplit{static_cast<Real>(cost)});
    const auto build = study::in_turns_ns(builds), render = study::in_turns_ns(renders);
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const auto& [name, variant, x, tree] = trials[i];
        const Tests tests = tests_per_ray(tree);
        const double ns = render[i] / static_cast<double>(shot.render(tree));
        study::Row row{.study = name,
                       .variant = variant,
                       .x = static_cast<double>(x),
                       .x_name = "spheres in a leaf",
                       .error = tests.boxes + tests.spheres,
                       .error_name = "tests per ray",
                       .cost = ns,
                       .cost_name = "time per ray / ns"};
        if (name == "build") {
            row.x = build[i] * 1e-6;
            row.x_name = "build time / ms";
        } else if (name == "boxes-cost") {
            row.x_name = "cost of both boxes";
            study::Row boxes = row, spheres = row;
            boxes.variant = "boxes", boxes.error = tests.boxes, boxes.cost_name = "";
            spheres.variant = "spheres", spheres.error = tests.spheres, spheres.cost_name = "";
            report.add(boxes);
            report.add(spheres);
            row.variant = "time", row.error_name = "";
        }
        report.add(row);
    }
}

// How the time of a ray and the time to build a tree grow with the number of spheres.
void study_growth(study::Report& report) {
    // The scenes that are searched, kept until all searches have been timed.
    std::deque<Cloud> clouds;
    std::deque<WideTree> wide_trees;
    std::deque<SphereTree> trees;
    std::vector<study::Row> building;
    for (const int count : {1'000, 10'000, 100'000, 1'000'000}) {
        const Cloud& cloud = clouds.emplace_back(count);
        WideTree by_sweep, in_bins;
        std::vector<study::Work> builds{
            [&] { in_bins = make_wide_tree<float>(cloud.spheres, binned_split); }};
        if (count <= 100'000)
            builds.push_back(
                [&] { by_sweep = make_wide_tree<float>(cloud.spheres, AreaSplit{1}); });
        const auto ns = study::in_turns_ns(builds);
        const auto build_row = [&](const char* name, const WideTree& tree, double time) {
            const double bytes = static_cast<double>(tree.nodes.size() * sizeof(tree.nodes[0]) +
                                                     tree.leaves.size() * sizeof(tree.leaves[0]) +
                                                     tree.places.size() * sizeof(tree.places[0]));
            building.push_back({"build-time", name, static_cast<double>(count), "spheres",
                                bytes / count, "bytes per sphere", time * 1e-6, "time / ms"});
        };
        build_row("8-wide, area in bins", in_bins, ns[0]);
        if (count <= 100'000) build_row("8-wide, area full sweep", by_sweep, ns[1]);

        const WideTree& tree = wide_trees.emplace_back(std::move(in_bins));
        const auto add = [&](const char* name, const char* tests_name, double tests,
                             const auto& world, const std::vector<Ray>& rays) {
            report.add({.study = "growth",
                        .variant = name,
                        .x = static_cast<double>(count),
                        .x_name = "spheres",
                        .error = tests,
                        .error_name = tests_name,
                        .cost_name = "time per ray / ns"},
                       search_all(world, rays), static_cast<double>(rays.size()));
        };
        add("8-wide float boxes", "wide tests per ray", wide_tests_per_ray(tree, cloud.rays), tree,
            cloud.rays);
        add("8-wide float boxes, random rays", "wide tests per ray",
            wide_tests_per_ray(tree, cloud.random_rays), tree, cloud.random_rays);
        // The tests in this tree are not counted, because each of them is of one box or sphere, not
        // of eight.
        if (count <= 100'000)
            add("tree sorted", "", 0, trees.emplace_back(make_tree(cloud.spheres, split_in_half)),
                cloud.rays);
    }
    report.time_in_turns({.rounds = 5});
    for (const study::Row& row : building) report.add(row);
}

// How many spheres there must be for a tree to be worthwhile.
void study_few(study::Report& report) {
    std::deque<Cloud> clouds;
    std::deque<SphereList> lists;
    std::deque<WideTree> trees;
    for (const int few : {1, 2, 4, 8, 16, 32}) {
        const Cloud& cloud = clouds.emplace_back(few);
        const auto add = [&](const char* name, const auto& world) {
            report.add({.study = "few",
                        .variant = name,
                        .x = static_cast<double>(few),
                        .x_name = "spheres",
                        .cost_name = "time per ray / ns"},
                       search_all(world, cloud.rays), static_cast<double>(cloud.rays.size()));
        };
        add("linear list", lists.emplace_back(SphereList{cloud.spheres}));
        add("8-wide float boxes", trees.emplace_back(make_wide_tree<float>(cloud.spheres)));
    }
    report.time_in_turns();
}

// A tree whose boxes are exactly as large as their spheres: neither boxes nor rays have a margin.
struct BareTree {
    SphereTree tree;

    explicit BareTree(const std::vector<SceneSphere>& spheres) {
        std::vector<Box> boxes;
        for (const SceneSphere& sphere : spheres) {
            const Real r = sphere.shape.radius;
            boxes.push_back(
                {sphere.shape.center - Vec3{r, r, r}, sphere.shape.center + Vec3{r, r, r}});
        }
        tree = make_tree(spheres, boxes, split_in_half);
    }
    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        Search search{tree.shapes, tree.order, {ray.origin, ray.direction}, within};
        search.slabs.margin = 0;
        if (search.meets(tree.root->box)) find_nearest(*tree.root, search);
        return hit_of(search);
    }
};

// How much each tree's picture differs from the list's.
void study_pixels(study::Report& report, const Scene& scene) {
    const auto add = [&](const std::string& variant, Real times, const auto& world) {
        const Camera camera = make_camera(study::from_afar(scene_view(), times), 96, 68);
        const auto draw = [&](const auto& any_world) {
            std::vector<Color> pixels;
            for (int y = 0; y < camera.height; ++y)
                for (int x = 0; x < camera.width; ++x)
                    pixels.push_back(render_pixel(camera, any_world, scene.materials, StudioSky{},
                                                  SkyEnding{}, Quality{1, 4, 1}, x, y));
            return pixels;
        };
        report.add(study::pixel_error(
            variant, static_cast<double>(times), "distance / the picture's",
            study::root_mean_square_error(draw(world), draw(PackedList{scene.spheres}))));
    };
    add("tree", 1, make_tree(scene.spheres, split_in_half));
    add("8-wide, float boxes", 1, make_wide_tree<float>(scene.spheres));
    const BareTree bare{scene.spheres};
    add("no margin", 1, bare);
    add("no margin, 1000 times as far away", 1000, bare);
}

void run_study(study::Report& report) {
    const Scene scene = make_scene(10'000, 1);
    study_searches(report, scene);
    study_splits(report, scene);
    study_growth(report);
    study_few(report);
    study_cover(report);
    study_pixels(report, scene);
}

}  // namespace
}  // namespace bvh

void (*const app::program_study)(study::Report&) = bvh::run_study;
