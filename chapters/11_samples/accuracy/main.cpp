// Measures what every setting of the ray tracer costs and what it is worth, for docs/accuracy.md.
//
//     accuracy_study DIR && accuracy_study_float DIR
//
// write DIR/accuracy.csv. The first program also saves the converged pictures in DIR, and the
// second program compares its own pictures with them.

#include <app/run.hpp>
#include <filesystem>
#include <fstream>
#include <rt/sphere_list.hpp>
#include <rt/tent_filter.hpp>

#include "../ways.hpp"
#include "equal_time.hpp"
#include "measured.hpp"
#include "subjects.hpp"

namespace rt {

inline Real scatter_density(const SchlickDielectric&, const Hit&, Vec3) {
    return 0;
}

}  // namespace rt

namespace accuracy {
namespace {

constexpr int width = 192, height = 108, usual_depth = 32, truth_depth = 64;
constexpr Tile whole{0, 0, width, height};

// Lamps that paths find by chance alone: empty() says that there are no lamps to sample.
template <class Lights>
struct ChanceLights : Lights {
    static constexpr bool empty() { return true; }
};

// A world in which hits at a t less than `nearest` do not count, as if the ray had started on the
// surface that it hits. A limit of 1 in this scene corresponds to a limit of 0.001 in a scene that
// is a thousand times smaller.
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

// The same materials, with Schlick's formula in place of Fresnel's equations.
template <class Material>
using WithSchlick =
    std::conditional_t<std::is_same_v<Material, Dielectric>, SchlickDielectric, Material>;

template <class... Types>
MaterialSet<WithSchlick<Types>...> with_schlick(const MaterialSet<Types...>& exact) {
    MaterialSet<WithSchlick<Types>...> all;
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

// The converged pictures of a scene, for both filters.
struct Truths {
    Truth box, displayed_box, tent, displayed_tent;

    std::array<Truth*, 4> all() { return {&box, &displayed_box, &tent, &displayed_tent}; }
};

// Write and read a converged picture: the program in double writes it, and the program in float
// reads it.
void write(std::ostream& out, const Truth& truth) {
    out.precision(17);
    out << truth.square << '\n';
    for (const double channel : truth.mean) out << channel << ' ';
    out << '\n';
}
void read(std::istream& in, Truth& truth) {
    truth.mean.resize(std::size_t{3} * width * height);
    in >> truth.square;
    for (double& channel : truth.mean) in >> channel;
}

template <Effects effects>
class Subject {
  public:
    Subject(std::string name, SceneDescription description, const std::filesystem::path& folder)
        : name_{std::move(name)}, description_{std::move(description)} {
        const auto file = folder / ("accuracy-" + name_ + ".truth");
        if (study::precision() == "double") {
            truths_ = find_truths();
            std::ofstream out{file};
            for (const Truth* truth : truths_.all()) write(out, *truth);
        } else {
            std::ifstream in{file};
            for (Truth* truth : truths_.all()) read(in, *truth);
            if (!in) throw std::runtime_error(file.string() + " is missing: run accuracy_study");
        }
    }

    // Adds settings that differ in where the samples are, how they are weighted, and how paths are
    // followed.
    void add_samplers(int most_samples) {
        for (int n = 4; n <= most_samples; n *= 4) {
            add("independent", n, [=, this](auto seed) {
                return draw_usual(samples::IndependentSamples{seed, n});
            });
            add("jittered", n, [=, this](auto seed) {
                return draw_usual(JitteredSamples{seed, n});
            });
            add("Sobol", n, [=, this](auto seed) { return draw_usual(SobolSamples{seed, n}); });
            add("Sobol in twin halves", n, [=, this](auto seed) { return draw_twins(seed, n); });
            add("Sobol, tent", n, [=, this](auto seed) { return draw_tent(renderer_, seed, n); });
            if constexpr (covers(batch_effects, effects)) {
                add("jittered in batches", n, [=, this](auto seed) {
                    return draw_batches(JitteredPoints{JitteredSamples{seed, n}});
                });
                add("Sobol in batches", n, [=, this](auto seed) {
                    return draw_batches(SobolPoints{{seed, n}});
                });
                add("Sobol in batches, tent", n, [=, this](auto seed) {
                    Batches<SobolPoints> renderer{scene_, usual_quality};
                    return draw_tent(renderer, seed, n);
                });
            }
        }
    }

    // Adds all other settings, with 16 of Sobol's points in each pixel.
    void add_settings() {
        for (const int depth : {4, 8, 16})
            add("depth " + std::to_string(depth), scene_.world, scene_.materials, scene_.lights,
                SkyEnding{}, depth);
        add("depth 8, black", scene_.world, scene_.materials, scene_.lights, BlackEnding{}, 8);
        add("roulette from 4", scene_.world, scene_.materials, scene_.lights, RouletteEnding{}, 4);
        add("Schlick", scene_.world, schlick_, scene_.lights);
        if constexpr (effects.lights)
            add("lamps by chance", scene_.world, scene_.materials, chance_);
        add("t > 0.001", skipping_, scene_.materials, scene_.lights);
        add("t > 0.001, scene / 1000", skipping_all_, scene_.materials, scene_.lights);
        add("list of spheres", list_, scene_.materials, scene_.lights);
        const auto widest = std::make_shared<const Renderer<every_effect>>(description_, width,
                                                                           height, usual_quality);
        add("every effect compiled in", usual_samples, [widest](auto seed) {
            return samples::draw_with(*widest, SobolSamples{seed, usual_samples}, width, height);
        });
    }

    void measure(study::Report& report) {
        accuracy::measure(measured_);
        for (const Measured& one : measured_) {
            const auto& [way, linear, displayed, ms] = one;
            const Measured& usual = jittered(way.samples);
            const auto add = [&](const char* study, double error, const char* error_name,
                                 double cost, const char* cost_name) {
                report.add({name_ + study, way.setting, static_cast<double>(way.samples),
                            "samples per pixel", error, error_name, cost, cost_name});
            };
            add("", linear.rmse(), "RMSE in a pixel", study::median(ms), "time / ms");
            add(" bias", linear.bias(), "bias in a pixel",
                50 * interval_of(linear.squares) / mean_of(linear.squares), "RMSE 95 % / +-%");
            const Worth in_light = worth(linear.squares, ms, usual.linear.squares, usual.ms);
            add(" worth", in_light.times, "1 / (error^2 time) / jittered's", in_light.percent,
                "95 % / +-%");
            add(" displayed", displayed.rmse(), "RMSE as displayed", 0, "");
            const Worth shown = worth(displayed.squares, ms, usual.displayed.squares, usual.ms);
            add(" displayed worth", shown.times, "1 / (error^2 time) / jittered's", shown.percent,
                "95 % / +-%");
        }
        const double ns = study::time_ns(
            [&] {
                study::keep(ReadyScene<effects>{description_, width, height});
            },
            {.rounds = 3});
        report.add({.study = "building",
                    .variant = name_,
                    .x = static_cast<double>(description_.spheres.size()),
                    .x_name = "spheres",
                    .cost = 1e-6 * ns,
                    .cost_name = "time / ms"});
    }

  private:
    static constexpr int usual_samples = 16;
    static constexpr Quality usual_quality{usual_samples, usual_depth, 1};
    template <class Points>
    using Batches = BatchRenderer<effects, Points>;

    const Measured& jittered(int samples) const {
        return *std::find_if(measured_.begin(), measured_.end(), [&](const Measured& one) {
            return one.way.setting == "jittered" && one.way.samples == samples;
        });
    }

    void add(const std::string& setting, int samples,
             std::function<Image(std::uint64_t seed)> draw) {
        const bool tent = setting.ends_with("tent");
        measured_.push_back({{setting, samples, std::move(draw)},
                             Errors{tent ? truths_.tent : truths_.box},
                             Errors{tent ? truths_.displayed_tent : truths_.displayed_box},
                             {}});
    }
    // The world, materials and lights must outlive this object.
    template <class World, class Materials, class Lights, class Ending = SkyEnding>
    void add(const std::string& setting, const World& world, const Materials& materials,
             const Lights& lights, const Ending& ending = {}, int depth = usual_depth) {
        add(setting, usual_samples, [=, this, &world, &materials, &lights](auto seed) {
            return draw(SobolSamples{seed, usual_samples}, world, materials, lights, ending, depth);
        });
    }

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
        for_each_pixel(whole, [&](int x, int y) {
            image.at(x, y) = pixel(samples, world, materials, lights, ending, depth, x, y);
        });
        return image;
    }
    template <class Samples>
    Image draw_usual(const Samples& samples) const {
        return draw(samples, scene_.world, scene_.materials, scene_.lights, SkyEnding{},
                    usual_depth);
    }
    template <class Points>
    Image draw_batches(const Points& points) const {
        Batches<Points> renderer{scene_, usual_quality};
        Image image = Canvas<Color>{width, height};
        std::uint64_t rays = 0;
        renderer.draw(points, whole, image, rays);
        return image;
    }
    template <class AnyRenderer>
    static Image draw_tent(AnyRenderer& renderer, std::uint64_t seed, int n) {
        Image image = Canvas<Color>{width, height};
        std::uint64_t rays = 0;
        draw_with_tent(renderer, SobolSamples{seed, n}, whole, image, rays);
        return image;
    }
    Image draw_twins(std::uint64_t seed, int n) const {
        return samples::refine({width, height, 4}, seed, n,
                               [&](int count) { return sobol_passes(renderer_, count); })
            .image;
    }

    Truths find_truths() const {
        constexpr int count = 1024;  // the samples of each half
        std::array<Image, 2> box, tent;
        for (const std::size_t half : {0, 1}) {
            box[half] = tent[half] = Canvas<Color>{width, height};
            TentSums filtered{whole};
            Canvas<ColorSum> sums{width, height};
            const auto keep = [&](int x, int y, Vec2 offset, const Color& light) {
                filtered.add(x, y, offset, light);
                if (x >= 0 && y >= 0 && x < width && y < height) sums.at(x, y).add(light);
            };
            const SobolSamples samples{1001 + half, count};
            const Quality quality{count, truth_depth, 1};
            std::uint64_t rays = 0;
            if constexpr (covers(batch_effects, effects)) {
                Batches<SobolPoints> renderer{scene_, quality};
                renderer.each({samples}, filtered.sampled(), rays, keep);
            } else {
                const Renderer<effects> renderer{description_, width, height, quality};
                for_each_pixel(filtered.sampled(), [&](int x, int y) {
                    const auto keep_here = [&](Vec2 offset, const Color& light) {
                        keep(x, y, offset, light);
                    };
                    renderer(KeptSamples<decltype(keep_here)>{samples, keep_here}, x, y, rays);
                });
            }
            filtered.write(tent[half]);
            for_each_pixel(whole,
                           [&](int x, int y) { box[half].at(x, y) = sums.at(x, y).mean(count); });
        }
        return {{linear(box[0]), linear(box[1])},
                {displayed(box[0]), displayed(box[1])},
                {linear(tent[0]), linear(tent[1])},
                {displayed(tent[0]), displayed(tent[1])}};
    }

    std::string name_;
    SceneDescription description_;
    ReadyScene<effects> scene_{description_, width, height};
    Renderer<effects> renderer_{description_, width, height, usual_quality};
    using World = std::decay_t<decltype(scene_.world)>;
    SphereList list_{prepare_shapes(description_).still};
    decltype(with_schlick(scene_.materials)) schlick_ = with_schlick(scene_.materials);
    ChanceLights<std::decay_t<decltype(scene_.lights)>> chance_{scene_.lights};
    SkippingWorld<World> skipping_{scene_.world, Real(0.001)}, skipping_all_{scene_.world, 1};
    Truths truths_;
    std::vector<Measured> measured_;
};

void run(const std::filesystem::path& folder) {
    study::Report report{"accuracy"};
    const auto measure = [&]<Effects effects>(const char* name, const SceneDescription& scene) {
        Subject<effects> subject{name, scene, folder};
        subject.add_samplers(64);
        subject.add_settings();
        subject.measure(report);
    };
    const auto measure_samplers = [&]<Effects effects>(const char* name,
                                                       const SceneDescription& scene) {
        Subject<effects> subject{name, scene, folder};
        subject.add_samplers(16);
        subject.measure(report);
    };
    measure.operator()<cover_effects>("cover", cover_scene());
    measure.operator()<lamp_effects>("lamps", lamp_scene());
    measure.operator()<glass_effects>("glass", glass_scene());
    measure_samplers.operator()<fog_effects>("fog", fog_scene());
    measure_samplers.operator()<bead_effects>("beads", bead_scene());
    study_equal_time(report);
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
