// embree_peer [ROUNDS [SAMPLES]]: chapters 08 and 10 beside the same paths with Embree's search, in
// one thread. README.md says how to read what it prints.

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <rt/batch_renderer.hpp>
#include <rt/batch_search.hpp>
#include <rt/cover_scene.hpp>
#include <rt/renderer.hpp>
#include <string>
#include <study/classic.hpp>
#include <study/median.hpp>
#include <study/timing.hpp>

#include "embree_drawing.hpp"

using namespace rt;
using peers::EmbreeDrawing, peers::EmbreeWorld, peers::picture_height, peers::picture_width;

namespace {

struct Result {
    double rays = 0, green = 0;  // 0 where it does not say
};
struct Contestant {
    std::string name;
    std::function<Result()> run;
};

// Prints a line for each: the medians of its times, and of the ratios to the second one's, round by
// round.
void print(const std::string& title, const std::vector<Contestant>& all, int rounds) {
    std::vector<Result> results(all.size());
    std::vector<study::Work> works;
    for (std::size_t i = 0; i < all.size(); ++i)
        works.push_back([&, i] { results[i] = all[i].run(); });
    const auto ns = study::rounds_ns(works, {.rounds = rounds});
    std::printf("\n%-36s %9s %9s %9s %9s\n", title.c_str(), "ms", "ns a ray", "ratio", "green");
    for (std::size_t i = 0; i < all.size(); ++i) {
        std::vector<double> ratios;
        for (std::size_t k = 0; k < ns[i].size(); ++k) ratios.push_back(ns[i][k] / ns[1][k]);
        const auto [rays, green] = results[i];
        const double median = study::median(ns[i]);
        std::printf("%-36s %9.1f", all[i].name.c_str(), 1e-6 * median);
        rays > 0 ? std::printf(" %9.1f", median / rays) : std::printf(" %9s", "-");
        std::printf(" %9.2f", study::median(ratios));
        green > 0 ? std::printf(" %9.4f\n", green) : std::printf(" %9s\n", "-");
    }
    std::fflush(stdout);
}

// The whole picture, drawn in all ways.
template <Effects effects>
void compare_pictures(const std::string& title, const SceneDescription& description,
                      const ReadyScene<effects>& scene, const Quality& quality, int rounds,
                      const study::Cover* cover) {
    const Renderer<effects> renderer{description, picture_width, picture_height, quality};
    BatchRenderer<effects> batches{scene, quality};
    Image image{picture_width, picture_height};
    const EmbreeDrawing<effects> drawing{scene, quality};
    const std::vector<SceneSphere> spheres = prepare_shapes(description).still;
    const EmbreeWorld world{spheres}, coherent{spheres, RTC_INTERSECT_CONTEXT_FLAG_COHERENT};
    const auto of_image = [&](std::uint64_t rays) {
        Color sum;
        for (const Color& pixel : image.pixels()) sum += pixel;
        return Result{static_cast<double>(rays),
                      static_cast<double>(sum.g) / picture_width / picture_height};
    };
    const auto of = [&](const auto& drawn) {
        const double samples = 1.0 * picture_width * picture_height * quality.samples_per_pixel;
        return Result{static_cast<double>(drawn.rays), static_cast<double>(drawn.sum.g) / samples};
    };
    const auto waves = [&](const EmbreeWorld& in, peers::Many search) {
        return [&, search] { return of(drawing.waves(in, search)); };
    };
    std::vector<Contestant> all{
        {"chapter 08",
         [&] {
             std::uint64_t rays = 0;
             for (int y = 0; y < picture_height; ++y)
                 for (int x = 0; x < picture_width; ++x) image.at(x, y) = renderer(x, y, rays);
             return of_image(rays);
         }},
        {"chapter 10",
         [&] {
             std::uint64_t rays = 0;
             batches.draw({0, 0, picture_width, picture_height}, image, rays);
             return of_image(rays);
         }},
        {"Embree, path by path", [&] { return of(drawing.paths(world)); }},
        {"Embree, waves, ray by ray", waves(world, &EmbreeWorld::single)},
        {"Embree, waves, streams", waves(world, &EmbreeWorld::stream)},
        {"Embree, waves, streams, coherent", waves(coherent, &EmbreeWorld::stream)},
        {"Embree, waves, packets of 8", waves(world, &EmbreeWorld::packets)}};
    std::shared_ptr<const study::classic::Hittable> classic;
    if (cover) {
        classic = study::classic::make_world(*cover);
        all.push_back({"classic tutorial", [&] {
                           const Color mean = study::classic::mean_color(*cover, *classic);
                           return Result{0, static_cast<double>(mean.g)};
                       }});
    }
    print(title + ", picture", all, rounds);
}

// The search alone, for the same rays: those of the picture, in waves.
template <Effects effects>
void compare_searches(const std::string& title, const SceneDescription& description,
                      const ReadyScene<effects>& scene, const Quality& quality, int rounds) {
    const std::vector<SceneSphere> spheres = prepare_shapes(description).still;
    const EmbreeWorld world{spheres}, coherent{spheres, RTC_INTERSECT_CONTEXT_FLAG_COHERENT};
    std::vector<std::vector<Ray>> waves;
    const auto keep_rays = [&](const auto& paths) {
        waves.emplace_back();
        for (const auto& path : paths) waves.back().push_back(path.ray);
    };
    const auto drawn =
        EmbreeDrawing<effects>{scene, quality}.waves(world, &EmbreeWorld::stream, keep_rays);
    const Result result{static_cast<double>(drawn.rays), 0};
    BatchSearch batches{scene.world};
    std::vector<PathRecord> records(batch_size);
    EmbreeWorld::Rays rays;
    const auto with = [&](const EmbreeWorld& in, peers::Many search) {
        return [&, search] {
            for (const auto& wave : waves) {
                rays.resize(wave.size());
                for (std::size_t i = 0; i < wave.size(); ++i) EmbreeWorld::put(wave[i], rays[i]);
                (in.*search)(rays);
            }
            return result;
        };
    };
    print(title + ", search",
          {{"chapter 07",
            [&] {
                for (const auto& wave : waves)
                    for (const Ray& ray : wave) study::keep(scene.world.search(ray, {}));
                return result;
            }},
           {"chapter 10",
            [&] {
                for (const auto& wave : waves) {
                    for (std::size_t i = 0; i < wave.size(); ++i) {
                        records[i].origin = wave[i].origin;
                        records[i].direction = wave[i].direction;
                        records[i].t = infinity;
                        records[i].sphere = -1;
                    }
                    const auto paths = std::span{records}.first(wave.size());
                    batches.make_ready(paths);
                    batches.find_nearest(paths);
                }
                return result;
            }},
           {"Embree, ray by ray", with(world, &EmbreeWorld::single)},
           {"Embree, streams", with(world, &EmbreeWorld::stream)},
           {"Embree, streams, coherent", with(coherent, &EmbreeWorld::stream)},
           {"Embree, packets of 8", with(world, &EmbreeWorld::packets)}},
          rounds);
}

template <Effects effects>
void compare(const std::string& title, const SceneDescription& description, const Quality& quality,
             int rounds, const study::Cover* cover = nullptr) {
    const ReadyScene<effects> scene{description, picture_width, picture_height};
    compare_pictures(title, description, scene, quality, rounds, cover);
    compare_searches(title, description, scene, quality, rounds);
}

// The cover scene with this many spheres in all: more small ones on the ground, as densely, farther
// and farther from its middle.
SceneDescription meadow(const study::Cover& cover, int count) {
    SceneDescription scene = cover_scene(cover);
    const std::size_t first = 4, small = cover.spheres.size() - first;  // of its spheres
    Rng random{10, 2};
    const int half = static_cast<int>(std::sqrt(static_cast<double>(count)) / 2);
    for (int row = -half; row < half; ++row)
        for (int column = -half; column < half; ++column) {
            if (std::max(std::abs(row), std::abs(column)) < 12) continue;
            const Real x = static_cast<Real>(row) + Real(0.9) * random.uniform(),
                       z = static_cast<Real>(column) + Real(0.9) * random.uniform();
            const Real radius = Real(0.2), from_middle = 1000 + radius;
            const Real y = std::sqrt(from_middle * from_middle - x * x - z * z) - 1000;
            scene.spheres.push_back(
                {{{x, y, z}, radius}, static_cast<int>(first + random() % small)});
        }
    return scene;
}

// Matte spheres anywhere in a cube, a twentieth of which they would fill if none met another.
SceneDescription crowd(int count) {
    SceneDescription scene;
    scene.camera.view = {{3, 2, 4}, {0, 0, 0}, {0, 1, 0}, radians(35)};
    scene.sky = {{1, 1, 1}, {Real(0.5), Real(0.7), 1}};
    scene.materials.push_back(Lambertian{{Real(0.7), Real(0.6), Real(0.5)}});
    const Real radius = std::cbrt(8 / Real(20) / (4 * pi / 3) / static_cast<Real>(count));
    Rng random{10, 1};
    const auto place = [&] { return random.uniform(-1, 1); };
    for (int i = 0; i < count; ++i) {
        const Real x = place(), y = place(), z = place();
        scene.spheres.push_back({{{x, y, z}, radius}, 0});
    }
    return scene;
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 9;
    const Quality quality{argc > 2 ? std::atoi(argv[2]) : 4, 50, 1};
    study::Cover cover = study::make_cover();
    cover.row_step = 1;
    cover.samples_per_pixel = quality.samples_per_pixel;
    constexpr Effects materials{.mirror = true, .fuzz = true, .glass = true, .texture = true};
    compare<materials>("cover, 486 spheres", cover_scene(cover), quality, rounds, &cover);
    for (const int count : {10'000, 100'000})
        compare<materials>("meadow, " + std::to_string(count) + " spheres", meadow(cover, count),
                           quality, rounds);
    for (const int count : {10'000, 100'000})
        compare<Effects{}>("crowd, " + std::to_string(count) + " spheres", crowd(count), quality,
                           rounds);
}
