#pragma once
// What a ray costs in each structure, how that grows, what a good tree costs to build, and the
// whole against the classic way.

#include <rt/counting_world.hpp>
#include <rt/flat_tree.hpp>
#include <rt/render_pixel.hpp>
#include <rt/split_by_area.hpp>
#include <rt/wide_builder.hpp>
#include <study/report.hpp>

#include "cover_study.hpp"
#include "scene.hpp"
#include "variants.hpp"

namespace bvh {

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
    // Nanoseconds a ray, shading and all.
    template <class World>
    double ns_per_ray(const World& world, int runs = 5) const {
        std::uint64_t rays = 1;
        const double ns = study::once_ns([&] { rays = render(world); }, runs);
        return ns / static_cast<double>(rays);
    }
};

// Boxes of a node and spheres of a leaf tested for a ray, eight at once counted as one.
inline double wide_tests_per_ray(const WideTree& tree, const std::vector<Ray>& rays) {
    double sum = 0;
    for (const Ray& ray : rays) {
        const auto found = tree.search(ray, {});
        sum += found.box_tests + found.sphere_tests;
    }
    return sum / static_cast<double>(rays.size());
}

inline void study_structures(study::Report& report) {
    const Scene scene = make_scene(10'000, 1);
    const Shot small{scene, 48, 34}, large{scene, 240, 170};
    const auto row = [&](const char* study, const char* variant, double x, const char* x_name,
                         double error, const char* error_name, double cost, const char* cost_name) {
        report.add({study, variant, x, x_name, error, error_name, cost, cost_name});
    };

    // Each structure on the same picture of 10,000 spheres.
    const SphereList list{scene.spheres};
    const PackedList packed{scene.spheres};
    const SphereTree sorted = make_tree(scene.spheres, split_in_half);
    const SphereTree by_area = make_tree(scene.spheres, split_by_area);
    const FlatTree flat = make_flat(by_area);
    const WideTreeOf<Real> wide = make_wide_tree<Real>(scene.spheres);
    const WideTree wide_float = make_wide_tree<float>(scene.spheres);
    const double of_list = small.ns_per_ray(list, 3);
    const auto structure = [&](const char* name, double ns) {
        row("structures", name, 10'000, "spheres", of_list / ns, "times as fast as the list", ns,
            "time per ray / ns");
    };
    structure("linear list", of_list);
    structure("linear list 8 at once", small.ns_per_ray(packed, 3));
    structure("tree sorted", large.ns_per_ray(sorted));
    structure("tree by area", large.ns_per_ray(by_area));
    structure("flat in order", large.ns_per_ray(FlatInOrder{flat}));
    structure("flat nearest first", large.ns_per_ray(flat));
    structure("8-wide", large.ns_per_ray(wide));
    structure("8-wide float boxes", large.ns_per_ray(wide_float));

    // Build quality against build time.
    const auto quality = [&](const char* study, const char* name, double x, const char* x_name,
                             const auto& split) {
        SphereTree tree;
        const double build = study::once_ns([&] { tree = make_tree(scene.spheres, split); }, 3);
        row(study, name, x < 0 ? build * 1e-6 : x, x_name, tests_per_ray(tree), "tests per ray",
            large.ns_per_ray(tree, 3), "time per ray / ns");
    };
    quality("build", "random axis", -1, "build time / ms", SplitRandomAxis{});
    quality("build", "sorted", -1, "build time / ms", split_in_half);
    quality("build", "area binned", -1, "build time / ms", SplitBinned{});
    quality("build", "area full sweep", -1, "build time / ms", split_by_area);
    for (const int size : {1, 2, 4, 8, 16, 32})
        quality("leaf-size", "sorted", size, "spheres in a leaf", SplitLeaf{size});

    // How the time grows with the number of spheres.
    std::vector<std::pair<double, double>> building;
    for (const int count : {1'000, 10'000, 100'000, 1'000'000}) {
        const Cloud cloud{count};
        WideTree tree;
        const double build =
            study::once_ns([&] { tree = make_wide_tree<float>(cloud.spheres); }, 1);
        const double bytes = static_cast<double>(tree.nodes.size() * sizeof(tree.nodes[0]) +
                                                 tree.leaves.size() * sizeof(tree.leaves[0]));
        row("growth", "8-wide float boxes", count, "spheres", wide_tests_per_ray(tree, cloud.rays),
            "wide tests per ray", cloud.ns_per_ray(tree), "time per ray / ns");
        building.push_back({build, bytes});
        row("growth", "8-wide float boxes, random rays", count, "spheres",
            wide_tests_per_ray(tree, cloud.random_rays), "wide tests per ray",
            cloud.ns_per_random_ray(tree), "time per ray / ns");
        // Its tests are not counted: they are of one box or sphere, not of eight.
        if (count <= 100'000)
            row("growth", "tree sorted", count, "spheres", 0, "",
                cloud.ns_per_ray(make_tree(cloud.spheres, split_in_half)), "time per ray / ns");
    }

    int count = 100;
    for (const auto& [ns, bytes] : building) {
        count *= 10;
        row("build-time", "8-wide float boxes", count, "spheres", bytes / count, "bytes per sphere",
            ns * 1e-6, "time / ms");
    }

    // How many spheres a tree is worth having for.
    for (const int few : {1, 2, 4, 8, 16, 32}) {
        const Cloud cloud{few};
        const SphereList all{cloud.spheres};
        const WideTree tree = make_wide_tree<float>(cloud.spheres);
        const auto world = [&](const char* name, double ns) {
            row("few", name, few, "spheres", 0, "", ns, "time per ray / ns");
        };
        world("linear list", cloud.ns_per_ray(all));
        world("8-wide float boxes", cloud.ns_per_ray(tree));
    }

    study_cover(report);
}

}  // namespace bvh
