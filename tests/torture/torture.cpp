#include "torture.hpp"

#include <rt/batch_renderer.hpp>
#include <rt/effects_of.hpp>
#include <rt/flat_tree.hpp>
#include <rt/render_tiles.hpp>
#include <rt/renderer.hpp>

namespace torture {
namespace {

constexpr Effects materials{.mirror = true, .fuzz = true, .glass = true, .texture = true};
constexpr std::uint64_t seed = 17;

// A part of a world, used without copying it.
template <class World>
struct Borrowed {
    const World& world;

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        return world.hit(ray, within);
    }
};

// The same, copied.
template <class World>
struct NearestOnly {
    World world;

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        return world.hit(ray, within);
    }
};

// A scene's world with another tree of the spheres that stand still. It is asked for the nearest
// hit even where any hit would do.
template <class Tree>
auto with_tree(const WideTree&, const Tree& tree) {
    return Borrowed<Tree>{tree};
}
template <class First, class Second, class Tree>
auto with_tree(const Aggregate<First, Second>& world, const Tree& tree) {
    const auto first = with_tree(world.first, tree);
    using Both = Aggregate<std::remove_const_t<decltype(first)>, Borrowed<Second>>;
    return NearestOnly<Both>{Both{first, {world.second}}};
}

// Draws with this world as Renderer does with its own; check(light) is called for each sample.
template <Effects effects, class World, class Check>
Image draw(const ReadyScene<effects>& scene, const World& world, const Frame& frame, int threads,
           const Check& check) {
    Image image{frame.width, frame.height};
    const JitteredSamples samples{seed, frame.samples};
    render_tiles({frame.width, frame.height, 5}, threads, [&](const Tile& tile, int) {
        for_each_pixel(tile, [&](int x, int y) {
            image.at(x,
                     y) = samples.average(scene.camera, x, y, [&](const auto& ray, auto& random) {
                Color light;
                if constexpr (effects.lights || effects.fog)
                    light = lit_path_radiance(ray, world, scene.materials, scene.sky, scene.lights,
                                              scene.fog, SkyEnding{}, frame.depth, random);
                else
                    light = path_radiance(ray, world, scene.materials, scene.sky, SkyEnding{},
                                          frame.depth, random);
                check(light);
                return light;
            });
        });
    });
    return image;
}

void check_light(Color light, Real most) {
    // A NaN fails every comparison.
    const auto allowed = [&](Real x) { return x >= 0 && x <= most; };
    if (allowed(light.r) && allowed(light.g) && allowed(light.b)) return;
    INFO("expected light from 0 to " << most << ", actual " << light);
    REQUIRE(is_finite(light));
    REQUIRE((light.r >= 0 && light.g >= 0 && light.b >= 0));
    REQUIRE((light.r <= most && light.g <= most && light.b <= most));
}

template <Effects effects>
Image draw_in_batches(const ReadyScene<effects>& scene, const Frame& frame, std::size_t size) {
    Image image{frame.width, frame.height};
    BatchRenderer<effects> renderer{scene, {frame.samples, frame.depth, seed}, size};
    std::uint64_t rays = 0;
    renderer.draw({0, 0, frame.width, frame.height}, image, rays);
    return image;
}

// The trees of the spheres that stand still.
struct Trees {
    SphereList list;
    SphereTree halved, by_area;
    FlatTree flat;

    explicit Trees(const SceneDescription& scene)
        : list{prepare_shapes(scene).still},
          halved{make_tree(list.spheres, split_in_half)},
          by_area{make_tree(list.spheres, AreaSplit{})},
          flat{make_flat(by_area)} {}
};

template <Effects effects>
Image draw_all(const SceneDescription& description, const Frame& frame) {
    const ReadyScene<effects> scene{description, frame.width, frame.height};
    const Trees trees{description};
    const Real most = effects_of(description).lights ? std::numeric_limits<Real>::max() : Real(1);
    const Image image = draw(scene, with_tree(scene.world, trees.list), frame, 1,
                             [&](Color light) { check_light(light, most); });
    const auto no_check = [](Color) {};
    const auto draws_the_same = [&](const char* by, const auto& tree) {
        INFO("drawn with " << by);
        CHECK(draw(scene, with_tree(scene.world, tree), frame, 1, no_check) == image);
    };
    draws_the_same("the tree by sorting", trees.halved);
    draws_the_same("the tree by surface area", trees.by_area);
    draws_the_same("the flat tree", trees.flat);
    for (const int threads : {1, 2, 3, 8}) {
        INFO("drawn with the eight-wide tree and " << threads << " threads");
        CHECK(draw(scene, scene.world, frame, threads, no_check) == image);
    }
    if constexpr (covers(batch_effects, effects))
        for (const std::size_t size : {std::size_t{7}, batch_size}) {
            INFO("drawn in batches of " << size);
            CHECK(draw_in_batches(scene, frame, size) == image);
        }
    // What a program draws with.
    const Renderer<effects> renderer{
        description, frame.width, frame.height, {frame.samples, frame.depth, seed}};
    CHECK(renderer(frame.width / 2, frame.height / 2) ==
          image.at(frame.width / 2, frame.height / 2));
    return image;
}

}  // namespace

Image draw_in_every_way(const SceneDescription& scene, const Frame& frame) {
    return covers(materials, effects_of(scene)) ? draw_all<materials>(scene, frame)
                                                : draw_all<every_effect>(scene, frame);
}

SceneDescription whitened(SceneDescription scene) {
    const Color white{1, 1, 1};
    scene.sky = {white, white};
    if (scene.fog) scene.fog->albedo = white;
    for (MaterialDescription& material : scene.materials) {
        if (auto* const matte = std::get_if<Lambertian>(&material)) matte->albedo = white;
        if (auto* const metal = std::get_if<Metal>(&material)) metal->albedo = white;
        if (auto* const checker = std::get_if<CheckeredMatte>(&material))
            checker->even = checker->odd = white;
        if (auto* const own = std::get_if<OwnMaterial>(&material)) own->color = white;
        if (auto* const emitter = std::get_if<Emitter>(&material)) emitter->radiance = white;
    }
    return scene;
}

SceneDescription scaled(SceneDescription scene, Real scale) {
    scene.camera.view.from = scale * scene.camera.view.from;
    scene.camera.view.at = scale * scene.camera.view.at;
    scene.camera.lens.aperture *= scale;
    scene.camera.lens.focus_distance *= scale;
    for (SphereDescription& sphere : scene.spheres) {
        sphere.shape = {scale * sphere.shape.center, scale * sphere.shape.radius};
        sphere.velocity = scale * sphere.velocity;
    }
    for (Mat4& map : scene.maps)
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column) map(row, column) *= scale;
    for (MaterialDescription& material : scene.materials)
        if (auto* const checker = std::get_if<CheckeredMatte>(&material)) checker->size *= scale;
    if (scene.fog) {
        Sphere& region = scene.fog->region;
        region = {scale * region.center, scale * region.radius};
        scene.fog->density /= scale;
    }
    return scene;
}

Image check_scene(const SceneDescription& scene, const Frame& frame) {
    const Image white{frame.width, frame.height, {1, 1, 1}};
    {
        INFO("all in white");
        CHECK(draw_in_every_way(whitened(scene), frame) == white);
    }
    return draw_in_every_way(scene, frame);
}

double brightness(const Image& image) {
    double sum = 0;
    for (const Color color : image.pixels())
        sum += static_cast<double>(color.r + color.g + color.b) / 3;
    return sum / static_cast<double>(image.pixels().size());
}

std::vector<checkpoint::Mean> pixel_means(const SceneDescription& description, const Frame& frame) {
    const ReadyScene<every_effect> scene{description, frame.width, frame.height};
    std::vector<checkpoint::Mean> pixels;
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) {
            checkpoint::Mean& mean = pixels.emplace_back();
            JitteredSamples{seed, frame.samples}.average(
                scene.camera, x, y, [&](const auto& ray, auto& random) {
                    const Color light = lit_path_radiance(ray, scene.world, scene.materials,
                                                          scene.sky, scene.lights, scene.fog,
                                                          SkyEnding{}, frame.depth, random);
                    check_light(light, std::numeric_limits<Real>::max());
                    mean.add(static_cast<double>(light.r + light.g + light.b) / 3);
                    return light;
                });
        }
    return pixels;
}

void check_hits(const SceneDescription& scene, const std::vector<Ray>& rays) {
    const Trees trees{scene};
    const WideTree wide = make_wide_tree(trees.list.spheres);
    std::vector<PathRecord> paths(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        paths[i].origin = rays[i].origin;
        paths[i].direction = rays[i].direction;
        paths[i].t = infinity;
        paths[i].sphere = -1;
    }
    BatchSearch batches{wide};
    batches.make_ready(paths);
    batches.find_nearest(paths);
    const auto same = [](const std::optional<Hit>& a, const std::optional<Hit>& b) {
        return a ? b && a->t == b->t && a->point == b->point && a->normal == b->normal &&
                       a->material == b->material && a->light == b->light
                 : !b;
    };
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray& ray = rays[i];
        const Interval within{0, infinity};
        const auto hit = trees.list.hit(ray, within);
        INFO("ray " << i << " from " << checkpoint::text(ray.origin) << " along "
                    << checkpoint::text(ray.direction));
        REQUIRE(same(trees.halved.hit(ray, within), hit));
        REQUIRE(same(trees.by_area.hit(ray, within), hit));
        REQUIRE(same(trees.flat.hit(ray, within), hit));
        REQUIRE(same(wide.hit(ray, within), hit));
        const auto nearest = nearest_sphere(trees.list.spheres, ray, within);
        REQUIRE(paths[i].sphere ==
                (nearest ? static_cast<PackInteger>(nearest->number) : PackInteger{-1}));
        REQUIRE(paths[i].t == (nearest ? nearest->t : infinity));
        // Nothing is in the way before the nearest hit, and something is if nothing is known of it.
        const Interval up_to_hit{0, paths[i].t};
        REQUIRE(!wide.occluded(ray, up_to_hit, static_cast<std::int32_t>(paths[i].sphere)));
        REQUIRE(wide.occluded(ray, up_to_hit) == (paths[i].sphere >= 0));
    }
}

std::vector<Color> light_along(const SceneDescription& description, const std::vector<Ray>& rays,
                               int depth, PathEnd end) {
    const auto all = prepare_materials<RendererTypes<materials>::Materials>(description);
    const Trees trees{description};
    const WideTree wide = make_wide_tree(trees.list.spheres);
    std::vector<Color> lights;
    for (const Ray& ray : rays) {
        const auto light = [&](const auto& world) {
            Rng random{seed, lights.size()};
            return end == PathEnd::sky
                       ? path_radiance(ray, world, all, description.sky, SkyEnding{}, depth, random)
                       : path_radiance(ray, world, all, description.sky, BlackEnding{}, depth,
                                       random);
        };
        const Color expected = light(trees.list);
        INFO("ray " << lights.size() << " from " << checkpoint::text(ray.origin) << " along "
                    << checkpoint::text(ray.direction));
        check_light(expected, 1);
        REQUIRE(light(trees.halved) == expected);
        REQUIRE(light(trees.by_area) == expected);
        REQUIRE(light(trees.flat) == expected);
        REQUIRE(light(wide) == expected);
        lights.push_back(expected);
    }
    return lights;
}

}  // namespace torture
