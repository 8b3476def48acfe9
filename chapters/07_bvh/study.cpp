#include "study.hpp"

#include <rt/counting_world.hpp>
#include <rt/flat_tree.hpp>
#include <rt/render_pixel.hpp>
#include <rt/split_by_area.hpp>
#include <rt/wide_builder.hpp>
#include <study/far_view.hpp>
#include <study/pixel_error.hpp>
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
    // Nanoseconds per ray, including shading.
    template <class World>
    double ns_per_ray(const World& world) const {
        std::uint64_t rays = 1;
        const double ns = study::time_ns([&] { rays = render(world); }, {.rounds = 3});
        return ns / static_cast<double>(rays);
    }
};

// Boxes of a node and spheres of a leaf tested for a ray, eight at once counted as one.
double wide_tests_per_ray(const WideTree& tree, const std::vector<Ray>& rays) {
    double sum = 0;
    for (const Ray& ray : rays) {
        const auto found = tree.search(ray, {});
        sum += found.box_tests + found.sphere_tests;
    }
    return sum / static_cast<double>(rays.size());
}

// Each structure on the same picture of 10,000 spheres.
void study_searches(study::Report& report, const Scene& scene) {
    const Shot small{scene, 48, 34}, large{scene, 160, 113};
    const SphereList list{scene.spheres};
    const PackedList packed{scene.spheres};
    const SphereTree sorted = make_tree(scene.spheres, split_in_half);
    const SphereTree by_area = make_tree(scene.spheres, split_by_area);
    const FlatTree flat = make_flat(by_area);
    const WideTreeOf<Real> wide = make_wide_tree<Real>(scene.spheres);
    const WideTree wide_float = make_wide_tree<float>(scene.spheres);
    const double of_list = small.ns_per_ray(list);
    const auto row = [&](const char* name, double ns) {
        report.add({"structures", name, 10'000, "spheres", of_list / ns,
                    "times as fast as the list", ns, "time per ray / ns"});
    };
    row("linear list", of_list);
    row("linear list 8 at once", small.ns_per_ray(packed));
    row("tree sorted", large.ns_per_ray(sorted));
    row("tree by area", large.ns_per_ray(by_area));
    row("flat in order", large.ns_per_ray(FlatInOrder{flat}));
    row("flat nearest first", large.ns_per_ray(flat));
    row("8-wide", large.ns_per_ray(wide));
    row("8-wide float boxes", large.ns_per_ray(wide_float));
}

// Build quality against build time, and against the size of the leaves.
void study_splits(study::Report& report, const Scene& scene) {
    const Shot shot{scene, 120, 85};
    const auto row = [&](const char* study, const char* name, double x, const char* x_name,
                         const auto& split) {
        SphereTree tree;
        const double build =
            study::time_ns([&] { tree = make_tree(scene.spheres, split); }, {.rounds = 3});
        report.add({study, name, x < 0 ? build * 1e-6 : x, x_name, tests_per_ray(tree),
                    "tests per ray", shot.ns_per_ray(tree), "time per ray / ns"});
    };
    row("build", "random axis", -1, "build time / ms", SplitRandomAxis{});
    row("build", "sorted", -1, "build time / ms", split_in_half);
    row("build", "area binned", -1, "build time / ms", split_binned);
    row("build", "area full sweep", -1, "build time / ms", split_by_area);
    for (const int size : {1, 2, 4, 8, 16, 32})
        row("leaf-size", "sorted", size, "spheres in a leaf", SplitLeaf{size});
}

// How the times of a ray and of building grow with the number of spheres.
void study_growth(study::Report& report) {
    std::vector<study::Row> building;
    for (const int count : {1'000, 10'000, 100'000, 1'000'000}) {
        const Cloud cloud{count};
        WideTree tree;
        const auto build_row = [&](const char* name, const auto& split) {
            const double build = study::time_ns(
                [&] { tree = make_wide_tree<float>(cloud.spheres, split); }, {.rounds = 1});
            const double bytes = static_cast<double>(tree.nodes.size() * sizeof(tree.nodes[0]) +
                                                     tree.leaves.size() * sizeof(tree.leaves[0]));
            building.push_back({"build-time", name, static_cast<double>(count), "spheres",
                                bytes / count, "bytes per sphere", build * 1e-6, "time / ms"});
        };
        build_row("8-wide, area in bins", binned_split);
        if (count <= 100'000) build_row("8-wide, area full sweep", split_by_area);
        const auto row = [&](const char* name, double tests, const char* tests_name, double ns) {
            report.add({"growth", name, static_cast<double>(count), "spheres", tests, tests_name,
                        ns, "time per ray / ns"});
        };
        row("8-wide float boxes", wide_tests_per_ray(tree, cloud.rays), "wide tests per ray",
            cloud.ns_per_ray(tree));
        row("8-wide float boxes, random rays", wide_tests_per_ray(tree, cloud.random_rays),
            "wide tests per ray", cloud.ns_per_random_ray(tree));
        // Its tests are not counted: they are of one box or sphere, not of eight.
        if (count <= 100'000)
            row("tree sorted", 0, "", cloud.ns_per_ray(make_tree(cloud.spheres, split_in_half)));
    }
    for (const study::Row& row : building) report.add(row);
}

// From how many spheres on a tree is worthwhile.
void study_few(study::Report& report) {
    for (const int few : {1, 2, 4, 8, 16, 32}) {
        const Cloud cloud{few};
        const SphereList all{cloud.spheres};
        const WideTree tree = make_wide_tree<float>(cloud.spheres);
        const auto row = [&](const char* name, double ns) {
            report.add(
                {"few", name, static_cast<double>(few), "spheres", 0, "", ns, "time per ray / ns"});
        };
        row("linear list", cloud.ns_per_ray(all));
        row("8-wide float boxes", cloud.ns_per_ray(tree));
    }
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
        Search search{tree.spheres, tree.order, {ray.origin, ray.direction}, within};
        search.slabs.margin = 0;
        find_nearest(*tree.root, search);
        return hit_of(search);
    }
};

// How a tree changes the pixels of the list's picture.
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

}  // namespace

void run_study(study::Report& report) {
    const Scene scene = make_scene(10'000, 1);
    study_searches(report, scene);
    study_splits(report, scene);
    study_growth(report);
    study_few(report);
    study_cover(report);
    study_pixels(report, scene);
}

}  // namespace bvh
