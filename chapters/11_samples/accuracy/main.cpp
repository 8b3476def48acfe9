// What every setting of the ray tracer costs and is worth, on three scenes: docs/accuracy.md.
//
//     accuracy_study DIR && accuracy_study_float DIR
//
// write DIR/accuracy.csv. The first one also leaves the converged pictures there; the second one
// compares its own pictures with them.

#include <app/run.hpp>
#include <filesystem>
#include <fstream>
#include <rt/batch_renderer.hpp>
#include <rt/sphere_list.hpp>
#include <string>
#include <study/pixel_error.hpp>
#include <study/timing.hpp>

#include "../ways.hpp"
#include "subjects.hpp"

namespace rt {

inline Real scatter_density(const SchlickDielectric&, const Hit&, Vec3) {
    return 0;
}

}  // namespace rt

namespace accuracy {
namespace {

constexpr int width = 64, height = 36, usual_depth = 32;
constexpr int truth_samples = 4096;

// Lamps that are found by chance alone: they say that there are none to aim at.
struct ChanceLights : SceneLights {
    static constexpr bool empty() { return true; }
};

// Hits nearer than this do not count, as if the ray had started on that very surface. In a scene
// that is a thousand times as small, 0.001 is what 1 is here.
template <class World>
struct SkippingWorld {
    const World& world;
    Real nearest;

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        within.min = std::max(within.min, nearest);
        return world.hit(ray, within);
    }
};

using SchlickMaterials =
    MaterialSet<Lambertian, Mirror, Metal, SchlickDielectric, CheckeredMatte, ImageMatte>;

template <class Materials>
SchlickMaterials with_schlick(const Materials& exact) {
    SchlickMaterials all;
    for (const auto& material : exact.materials)
        std::visit(
            [&](const auto& kind) {
                if constexpr (std::is_same_v<decltype(kind), const Dielectric&>)
                    all.materials.emplace_back(SchlickDielectric{kind.index});
                else
                    all.materials.emplace_back(kind);
            },
            material);
    return all;
}

template <Effects effects>
class Subject {
  public:
    Subject(std::string name, SceneDescription description, study::Report& report,
            const std::filesystem::path& folder)
        : name_{std::move(name)}, description_{std::move(description)}, report_{report} {
        truth_ = find_truth(folder / ("accuracy-" + name_ + ".truth"));
    }

    void measure_all() {
        const auto& [camera, world, materials, sky, lights, fog, haze] = scene_;
        using World = std::decay_t<decltype(world)>;
        const auto sobol = [](std::uint64_t seed, int n) { return SobolSamples{seed, n}; };
        const auto add_singly = [&](const char* setting, const auto& in, const auto& of,
                                    const auto& lit_by, const auto& ending, int depth) {
            add(setting, [&, depth](int n, std::uint64_t seed) {
                return draw(sobol(seed, n), in, of, lit_by, ending, depth);
            });
        };
        add("independent", [&](int n, std::uint64_t seed) {
            return draw_usual(samples::IndependentSamples{seed, n});
        });
        add("jittered", [&](int n, std::uint64_t seed) {
            return draw_usual(JitteredSamples{seed, n});
        });
        add("Sobol", [&](int n, std::uint64_t seed) { return draw_usual(sobol(seed, n)); });
        if constexpr (covers(batch_effects, effects))
            add("jittered in batches",
                [&](int n, std::uint64_t seed) { return draw_batches(n, seed); });
        add("Sobol in twin halves", [&](int n, std::uint64_t seed) { return draw_twins(n, seed); });
        for (const int depth : {2, 4, 8, 16})
            add_singly(("depth " + std::to_string(depth)).c_str(), world, materials, lights,
                       SkyEnding{}, depth);
        add_singly("depth 8, black", world, materials, lights, BlackEnding{}, 8);
        add_singly("roulette from 4", world, materials, lights, RouletteEnding{}, 4);
        add_singly("Schlick", world, with_schlick(materials), lights, SkyEnding{}, usual_depth);
        if constexpr (effects.lights)
            add_singly("lamps by chance", world, materials, ChanceLights{lights}, SkyEnding{},
                       usual_depth);
        add_singly("t > 0.001", SkippingWorld<World>{world, Real(0.001)}, materials, lights,
                   SkyEnding{}, usual_depth);
        add_singly("t > 0.001, scene / 1000", SkippingWorld<World>{world, 1}, materials, lights,
                   SkyEnding{}, usual_depth);
        add_singly("list of spheres", list(), materials, lights, SkyEnding{}, usual_depth);
        const Renderer<every_effect> widest{description_, width, height, {1, usual_depth, 1}};
        add("every effect compiled in", [&](int n, std::uint64_t seed) {
            return samples::draw_with(widest, sobol(seed, n), width, height);
        });
    }

  private:
    static constexpr Effects every_effect{.mirror = true,
                                          .fuzz = true,
                                          .glass = true,
                                          .texture = true,
                                          .lens = true,
                                          .motion = true,
                                          .lights = true,
                                          .fog = true,
                                          .instances = true};

    template <class Samples, class World, class Materials, class Lights, class Ending>
    RT_INLINES_ALL Color pixel(const Samples& samples, const World& world,
                               const Materials& materials, const Lights& lights,
                               const Ending& ending, int depth, int x, int y) const {
        return samples.average(scene_.camera, x, y, [&](const auto& ray, auto& random) {
            if constexpr (effects.lights)
                return lit_path_radiance(ray, world, materials, scene_.sky, lights, scene_.fog,
                                         ending, depth, random);
            else
                return path_radiance(ray, world, materials, scene_.sky, ending, depth, random);
        });
    }
    template <class Samples, class World, class Materials, class Lights, class Ending>
    Image draw(const Samples& samples, const World& world, const Materials& materials,
               const Lights& lights, const Ending& ending, int depth) const {
        Image image = Canvas<Color>{width, height};
        for_each_pixel({0, 0, width, height}, [&](int x, int y) {
            image.at(x, y) = pixel(samples, world, materials, lights, ending, depth, x, y);
        });
        return image;
    }
    template <class Samples>
    Image draw_usual(const Samples& samples, int depth = usual_depth) const {
        return draw(samples, scene_.world, scene_.materials, scene_.lights, SkyEnding{}, depth);
    }

    Image draw_batches(int n, std::uint64_t seed) const {
        BatchRenderer<effects> renderer{scene_, {n, usual_depth, seed}};
        Image image = Canvas<Color>{width, height};
        std::uint64_t rays = 0;
        renderer.draw({0, 0, width, height}, image, rays);
        return image;
    }
    Image draw_twins(int n, std::uint64_t seed) const {
        const Renderer<effects> renderer{description_, width, height, {1, usual_depth, 1}};
        return samples::refine({width, height, 4}, seed, n,
                               [&](int count) { return sobol_passes(renderer, count); })
            .image;
    }

    SphereList list() const { return {prepare_shapes(description_).still}; }

    // One picture for both precisions: that of double.
    Image find_truth(const std::filesystem::path& file) const {
        if (study::precision() == "double") {
            const Image truth = draw_usual(SobolSamples{77, truth_samples}, 64);
            std::ofstream out{file};
            out.precision(17);
            for (const Color& color : truth.pixels())
                out << color.r << ' ' << color.g << ' ' << color.b << '\n';
            return truth;
        }
        Image truth = Canvas<Color>{width, height};
        std::ifstream in{file};
        for_each_pixel({0, 0, width, height}, [&](int x, int y) {
            Color& color = truth.at(x, y);
            in >> color.r >> color.g >> color.b;
        });
        if (!in) throw std::runtime_error(file.string() + " cannot be read: run accuracy_study");
        return truth;
    }

    // The error and the time of a setting, over the samples. The error is known
    // best where samples are few.
    template <class Draw>
    void add(const std::string& setting, const Draw& draw_picture) {
        for (int n = 1; n <= 64; n *= 4) {
            const int seeds = n == 64 ? 2 : 4;
            double squares = 0;
            const double ns = study::time_ns(
                [&] {
                    for (int seed = 1; seed <= seeds; ++seed) {
                        const Image image = draw_picture(n, static_cast<std::uint64_t>(seed));
                        const double error =
                            study::root_mean_square_error(image.pixels(), truth_.pixels());
                        squares += error * error / seeds;
                    }
                },
                {.rounds = 1});
            report_.add({name_, setting, static_cast<double>(n), "samples per pixel",
                         std::sqrt(squares), "RMSE in a pixel", 1e-6 * ns / seeds, "time / ms"});
        }
    }

    std::string name_;
    SceneDescription description_;
    ReadyScene<effects> scene_{description_, width, height};
    Image truth_;
    study::Report& report_;
};

void run(const std::filesystem::path& folder) {
    study::Report report{"accuracy"};
    Subject<cover_effects>{"cover", cover_scene(), report, folder}.measure_all();
    Subject<lamp_effects>{"lamps", lamp_scene(), report, folder}.measure_all();
    Subject<glass_effects>{"glass", glass_scene(), report, folder}.measure_all();
    report.print_table(stdout);
    app::write_study(report, folder);
}

}  // namespace
}  // namespace accuracy

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s DIR\n", argv[0]);
        return 2;
    }
    try {
        accuracy::run(argv[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
        return 1;
    }
}
