// How well each way finds light, how many digits the formulas lose, and what each effect costs.

#include <app/run.hpp>
#include <array>
#include <memory>
#include <rt/canvas.hpp>
#include <rt/cover_scene.hpp>
#include <rt/effects_of.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/light_sample.hpp>
#include <rt/renderer.hpp>
#include <rt/shared_weight.hpp>
#include <rt/sphere_light.hpp>
#include <study/classic.hpp>
#include <study/double_double.hpp>
#include <study/pixel_error.hpp>
#include <study/report.hpp>
#include <study/timing.hpp>
#include <study/ulp.hpp>

#include "pixel_renderer.hpp"
#include "study_scene.hpp"

namespace effects {
namespace {

using namespace rt;

// One sample's estimate of the irradiance (divided by pi) of a floor that faces a light, for
// several ways to look for the light. The right answer is sin^2 a, where 2 a is the angle that the
// light fills as seen from the floor.
struct LightAbove {
    Real distance;  // of a light of radius 1
    Sphere light() const { return {{0, distance, 0}, 1}; }

    // Follows a random path, which has to meet the light by itself.
    Real by_chance(Rng& random) const {
        const Vec3 direction = cosine_direction({0, 1, 0}, random_place(random));
        return meets(direction) ? 1 : 0;
    }
    // Chooses a point anywhere on the light, even on its far side.
    Real by_area(Rng& random) const {
        const Vec3 normal = uniform_direction(random_place(random));
        const Vec3 apart = light().center + normal;
        const Real squared = dot(apart, apart);
        const Vec3 direction = apart / std::sqrt(squared);
        const Real facing = -dot(normal, direction);
        return facing > 0 ? 4 * direction.y * facing / squared : 0;
    }
    Real by_cone(Rng& random) const {
        const auto sample = sample_light(light(), {0, 0, 0}, random_place(random));
        return sample->direction.y / (pi * sample->density);
    }
    // Samples both the cone of the light and the path, and weights the two samples.
    Real by_both(Rng& random) const {
        const auto sample = sample_light(light(), {0, 0, 0}, random_place(random));
        const Real toward = sample->direction.y / pi;
        Real sum = toward / sample->density * shared_weight(sample->density, toward);
        const Vec3 direction = cosine_direction({0, 1, 0}, random_place(random));
        if (meets(direction))
            sum += shared_weight(direction.y / pi, light_density(light(), {0, 0, 0}));
        return sum;
    }
    bool meets(Vec3 direction) const {
        return hit_sphere(light(), {{0, 0, 0}, direction}, {}).has_value();
    }
};

// Four ways to find a light: how far one sample is from the right answer, and its time.
void study_light(study::Report& report) {
    using Way = Real (LightAbove::*)(Rng&) const;
    constexpr std::array<std::pair<const char*, Way>, 4> ways{
        {{"by chance", &LightAbove::by_chance},
         {"point on the sphere", &LightAbove::by_area},
         {"cone", &LightAbove::by_cone},
         {"cone and chance", &LightAbove::by_both}}};
    for (const auto& named_way : ways)
        for (const Real distance : {Real(1.1), Real(1.5), Real(3), Real(10), Real(30), Real(100)}) {
            const Way way = named_way.second;
            const LightAbove scene{distance};
            const double expected = 1 / static_cast<double>(distance * distance);
            Rng random{8, 3};
            double squares = 0;
            constexpr int timed = 100'000;
            // By chance, one direction in distance^2 meets the light. On average, a thousand
            // directions have to meet it: if only a few did, their number would vary too much.
            const int count = way == &LightAbove::by_chance
                                  ? std::max(timed, static_cast<int>(1000 / expected))
                                  : timed;
            for (int i = 0; i < count; ++i) {
                const double off = static_cast<double>((scene.*way)(random)) - expected;
                squares += off * off;
            }
            const auto many = [=]() mutable {
                for (int i = 0; i < timed; ++i) study::keep((scene.*way)(random));
            };
            report.add({.study = "light",
                        .variant = named_way.first,
                        .x = static_cast<double>(distance),
                        .x_name = "distance / radius",
                        .error = std::sqrt(squares / count) / expected,
                        .error_name = "error of one sample / mean",
                        .cost_name = "time per sample / ns"},
                       many, timed);
        }
    report.time_in_turns();
}

// Pixels of a floor that the light makes white, each the mean of 100 samples.
void study_pixels(study::Report& report) {
    constexpr int pixels = 1000, samples = 100;
    const auto add = [&](const std::string& name, Real (LightAbove::*way)(Rng&) const,
                         Real distance) {
        Rng random{8, 5};
        std::vector<Color> found;
        for (int i = 0; i < pixels; ++i) {
            Real sum = 0;
            for (int k = 0; k < samples; ++k) sum += (LightAbove{distance}.*way)(random);
            const Real light = sum / samples * (distance * distance);
            found.push_back({light, light, light});
        }
        report.add(study::pixel_error(
            name, static_cast<double>(distance), "distance / radius",
            study::root_mean_square_error(found, std::vector<Color>(pixels, Color{1, 1, 1}))));
    };
    add("by chance, 3 radii away", &LightAbove::by_chance, 3);
    add("cone, 3 radii away", &LightAbove::by_cone, 3);
    add("by chance, 100 radii away", &LightAbove::by_chance, 100);
    add("cone, 100 radii away", &LightAbove::by_cone, 100);
}

// How accurate a formula is for 1 - cos a, the height of the cap that the light covers on the
// sphere of directions.
template <class Formula>
void study_cap(study::Report& report, const char* name, double power, Formula formula) {
    using Exact = study::DoubleDouble;
    constexpr int count = 200;
    std::vector<Real> distances;
    Rng random{8, 4};
    for (int i = 0; i < count; ++i)
        distances.push_back(static_cast<Real>(std::pow(10, power)) * random.uniform(1, 2));
    double largest = 0;
    for (const Real distance : distances) {
        const Exact d = static_cast<double>(distance), one = 1;
        const Exact cosine = sqrt((d - one) * (d + one)) / d;
        largest =
            std::max(largest, std::min(1e18, study::error_in_ulp(formula(Real(1), distance),
                                                                 one / (d * d) / (one + cosine))));
    }
    const auto all = [=] {
        for (const Real distance : distances) study::keep(formula(Real(1), distance));
    };
    report.add({.study = "solid-angle",
                .variant = name,
                .x = std::pow(10, power),
                .x_name = "distance / radius",
                .error = largest,
                .error_name = "largest error / ulp",
                .cost_name = "time / ns"},
               all, count);
}

void study_solid_angle(study::Report& report) {
    const auto naive = [](Real radius, Real distance) {
        const Real sine = radius / distance;
        return 1 - std::sqrt(1 - sine * sine);
    };
    for (double power = 0.5; power < 9; ++power) {
        study_cap(report, "1 - cos", power, naive);
        study_cap(report, "sin^2 / (1 + cos)", power, cone_height);
    }
    report.time_in_turns();
}

constexpr int width = 64, rows = 36;

// Draws a scene with a renderer that has exactly these effects, and counts the rays.
template <Effects effects>
study::Work drawing(const SceneDescription& scene, std::uint64_t& rays) {
    constexpr JitteredSamples samples{1, 4};
    const auto renderer = std::make_shared<const Renderer<effects>>(
        scene, width, rows, Quality{samples.count, 8, samples.seed});
    return [renderer, samples, &rays] {
        rays = 0;
        Image image = Canvas<Color>{width, rows};
        for_each_pixel(Tile{0, 0, width, rows},
                       [&](int x, int y) { image.at(x, y) = (*renderer)(samples, x, y, rays); });
        study::keep(image);
    };
}

// What the effect with this number costs where it is absent, compiled in but unused, and present.
template <std::size_t number>
void study_effect(study::Report& report) {
    constexpr Effects one = [] {
        Effects effects;
        effects.*all_effects[number].member = true;
        return effects;
    }();
    const SceneDescription without = study_scene({}), with = study_scene(one);
    std::array<std::uint64_t, 3> rays{};
    std::vector<double> per_ray =
        study::in_turns_ns({drawing<Effects{}>(without, rays[0]), drawing<one>(without, rays[1]),
                            drawing<one>(with, rays[2])},
                           {.rounds = 9});
    for (std::size_t i = 0; i < rays.size(); ++i) {
        per_ray[i] /= static_cast<double>(rays[i]);
        report.add({"effects", all_effects[number].name, static_cast<double>(i),
                    "absent, compiled in, present", per_ray[i] / per_ray[0],
                    "times the time without", per_ray[i], "time per ray / ns"});
    }
}

void study_each_effect(study::Report& report) {
    [&]<std::size_t... number>(std::index_sequence<number...>) {
        (study_effect<number>(report), ...);
    }
    (std::make_index_sequence<all_effects.size()>{});
}

// The time of the whole cover scene, compared with that of the classic way.
void study_cover(study::Report& report) {
    const study::Cover cover = study::make_cover();
    const auto classic = study::classic::make_world(cover);
    const SceneDescription scene = study::cover_scene(cover);
    const auto ns = study::in_turns_ns(
        {[&] { study::keep(study::classic::mean_color(cover, *classic)); },
         [&] {
             const DrawTile draw =
                 pixel_by_pixel(make_narrowest(effects_of(scene), scene, cover.width, cover.height,
                                               {cover.samples_per_pixel, cover.depth, 1})
                                    .color);
             Image image = Canvas<Color>{cover.width, cover.height};
             std::uint64_t rays = 0;
             for (int y = 0; y < cover.height; y += cover.row_step)
                 draw({0, y, cover.width, y + 1}, image, rays);
             study::keep(study::mean_color(cover, [&](int x, int y) { return image.at(x, y); }));
         }});
    constexpr std::array<const char*, 2> names{"classic", "narrowest renderer"};
    for (std::size_t i = 0; i < names.size(); ++i)
        report.add({"cover", names[i], static_cast<double>(cover.spheres.size()), "spheres",
                    ns[0] / ns[i], "times as fast", cover.whole_ms(ns[i]), "time / ms"});
}

void run_study(study::Report& report) {
    study_light(report);
    study_solid_angle(report);
    study_each_effect(report);
    study_cover(report);
    study_pixels(report);
}

}  // namespace
}  // namespace effects

void (*const app::program_study)(study::Report&) = effects::run_study;
