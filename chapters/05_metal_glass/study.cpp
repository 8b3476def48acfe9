// What accuracy costs: reflectance, refraction, fuzz, the depth limit, and the choice of a
// material.

#include <app/run.hpp>
#include <array>
#include <cmath>
#include <cstdio>
#include <rt/make_camera.hpp>
#include <rt/render_pixel.hpp>
#include <rt/transform.hpp>
#include <string>
#include <study/pixel_error.hpp>
#include <study/report.hpp>
#include <study/timing.hpp>
#include <study/ulp.hpp>
#include <vector>

#include "glass_strip.hpp"
#include "scene.hpp"
#include "virtual_material.hpp"

namespace metal_glass_study {
namespace {

using namespace rt;
using study::DoubleDouble;

DoubleDouble wide(Real x) {
    return static_cast<double>(x);
}

std::string with_index(const char* name, double index) {
    char text[64];
    std::snprintf(text, sizeof text, "%s, n = %g", name, index);
    return text;
}

// The classic mistake: Schlick's formula with the cosine on the light's own
// side, whichever side that is.
Real schlick_by_inner_cosine(Real cosine, Real eta) {
    const Real r = (1 - eta) / (1 + eta), x = 1 - cosine;
    return r * r + (1 - r * r) * (x * x) * (x * x) * x;
}

// Fresnel's equations, computed with twice the digits of double.
double exact_reflectance(Real cosine, Real eta) {
    const DoubleDouble c = wide(cosine), e = wide(eta), one = 1;
    const DoubleDouble squared = one - e * e * (one - c) * (one + c);
    if (squared.high < 0) return 1;
    const DoubleDouble beyond = sqrt(squared);
    const DoubleDouble s = (e * c - beyond) / (e * c + beyond),
                       p = (c - e * beyond) / (c + e * beyond);
    return ((s * s + p * p) / DoubleDouble(2)).high;
}

struct Reflectance {
    const char* name;
    Real (*function)(Real cosine, Real eta);
};

// Work to be timed: all cosines from 0 to 1.
constexpr int cosines = 2048;
study::Work all_cosines(Real (*function)(Real, Real), Real eta) {
    return [=] {
        Real sum = 0;
        for (int i = 1; i <= cosines; ++i) sum += function(static_cast<Real>(i) / cosines, eta);
        study::keep(sum);
    };
}

void add_reflectance(study::Report& report) {
    const std::array<double, 6> indices{1.1, 1.3, 1.5, 1.7, 2.0, 2.5};
    const auto error = [](Real (*function)(Real, Real), Real cosine, Real eta) {
        return std::abs(static_cast<double>(function(cosine, eta)) -
                        exact_reflectance(cosine, eta));
    };
    for (const double index : indices) {
        const Real eta = 1 / static_cast<Real>(index);
        for (const int degrees : {30, 40, 45, 50, 55, 60, 65, 70, 75, 80, 83, 86, 89}) {
            const Real cosine = std::cos(radians(static_cast<Real>(degrees)));
            report.add({.study = "Schlick over the angle",
                        .variant = with_index("Schlick", index),
                        .x = static_cast<double>(degrees),
                        .x_name = "angle in air / degrees",
                        .error = error(schlick_reflectance, cosine, eta),
                        .error_name = "error of reflectance",
                        .cost_name = "time / ns"},
                       all_cosines(schlick_reflectance, eta), cosines);
        }
    }
    const std::array<Reflectance, 3> ways{{{"exact", fresnel_reflectance},
                                           {"Schlick", schlick_reflectance},
                                           {"Schlick by inner cosine", schlick_by_inner_cosine}}};
    for (const Reflectance& way : ways)
        for (const bool inside : {false, true})
            for (const double index : indices) {
                const Real n = static_cast<Real>(index), eta = inside ? n : 1 / n;
                double worst = 0;
                for (int i = 1; i <= cosines; ++i)
                    worst =
                        std::max(worst, error(way.function, static_cast<Real>(i) / cosines, eta));
                report.add({.study = "Reflectance",
                            .variant = std::string(way.name) + (inside ? ", inside" : ", outside"),
                            .x = index,
                            .x_name = "index of refraction",
                            .error = worst,
                            .error_name = "largest error",
                            .cost_name = "time / ns"},
                           all_cosines(way.function, eta), cosines);
            }
    report.time_in_turns();
}

// A ball of glass, as the strip below the picture shows it: both the reflected and the refracted
// ray are followed at each surface, so that nothing is random.
std::vector<Color> draw_ball(double index, Real (*reflectance)(Real, Real)) {
    const SphereList ball{{{{{0, 0, 0}, 1}, 0}}};
    const Camera camera =
        make_camera({{0, Real(0.4), 5}, {0, 0, 0}, {0, 1, 0}, radians(26)}, 48, 48);
    std::uint64_t rays = 0;
    std::vector<Color> pixels;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            pixels.push_back(
                scene::light_through_glass(primary_ray(camera, x, y, {Real(0.5), Real(0.5)}), ball,
                                           {static_cast<Real>(index), 1, 1}, reflectance, 8, rays));
    return pixels;
}

void add_pixel_errors(study::Report& report) {
    for (const double index : {1.1, 1.5, 2.4}) {
        const auto truth = draw_ball(index, fresnel_reflectance);
        for (const Reflectance& way :
             {Reflectance{"Schlick", schlick_reflectance},
              Reflectance{"Schlick by inner cosine", schlick_by_inner_cosine}})
            report.add(study::pixel_error(
                with_index(way.name, index), index, "index of refraction",
                study::root_mean_square_error(draw_ball(index, way.function), truth)));
    }
}

// What most textbooks do: like rt::refract, but without its second look near the critical angle.
std::optional<Vec3> refract_without_doubt(Vec3 incoming, Vec3 normal, Real eta) {
    const Real cosine = -dot(incoming, normal);
    const Vec3 along = eta * (incoming + cosine * normal);
    const Real squared_cosine = 1 - dot(along, along);
    if (squared_cosine < 0) return {};
    return along - std::sqrt(squared_cosine) * normal;
}

// Every sine comes from a cross product, so that near the critical angle no second look is needed.
std::optional<Vec3> refract_by_cross(Vec3 incoming, Vec3 normal, Real eta) {
    const Vec3 across = cross(normal, incoming);
    const Real sine = length(across);
    const Real excess = std::fma(eta, sine, Real(-1));
    if (excess > 0) return {};
    return eta * cross(across, normal) - std::sqrt(-excess * (1 + eta * sine)) * normal;
}

// The sine of the angle between a unit vector n and a vector v of nearly length 1, with twice the
// digits of double.
DoubleDouble exact_sine(Vec3 v, Vec3 n) {
    const auto difference = [](Real a, Real b, Real c, Real d) {
        return wide(a) * wide(b) - wide(c) * wide(d);
    };
    const DoubleDouble x = difference(n.y, v.z, n.z, v.y), y = difference(n.z, v.x, n.x, v.z),
                       z = difference(n.x, v.y, n.y, v.x);
    return sqrt(x * x + y * y + z * z);
}

struct Refraction {
    const char* name;
    std::optional<Vec3> (*refract)(Vec3, Vec3, Real);
};
constexpr std::array<Refraction, 3> refractions{{{"textbook", refract_without_doubt},
                                                 {"cross products", refract_by_cross},
                                                 {"rt::refract", rt::refract}}};

// Adds a row whose cost is the time of a refraction.
void add_refraction_row(study::Report& report, const study::Row& row, const Refraction& way,
                        const std::vector<Vec3>& lights, Vec3 n, Real eta) {
    const auto refract_all = [=] {
        Vec3 sum;
        for (const Vec3 v : lights)
            if (const auto r = way.refract(v, n, eta)) sum += *r;
        study::keep(sum);
    };
    report.add(row, refract_all, static_cast<double>(lights.size()));
}

void add_refraction(study::Report& report) {
    const Mat4 tilt = multiply(rotation_x(1), rotation_z(1));
    const Vec3 n = normalize(transform_vector(tilt, {0, 1, 0}));
    for (const double sine : {0.001, 0.01, 0.1, 0.3, 0.6, 0.9, 0.99}) {
        std::vector<Vec3> lights;
        Rng rng{1, 1};
        while (lights.size() < 2048) {
            const Real s = static_cast<Real>(sine) * rng.uniform(Real(0.9), 1);
            const Real turn = rng.uniform(0, 2 * pi);
            lights.push_back(normalize(transform_vector(
                tilt, {s * std::cos(turn), -std::sqrt(1 - s * s), s * std::sin(turn)})));
        }
        const Real eta = 1 / Real(1.5);
        for (const Refraction& way : refractions) {
            double worst = 0;
            for (const Vec3 v : lights) {
                const DoubleDouble expected = wide(eta) * exact_sine(v, n);
                const DoubleDouble error = exact_sine(*way.refract(v, n, eta), n) - expected;
                worst = std::max(worst, std::abs(error.high));
            }
            add_refraction_row(report,
                               {.study = "Refraction",
                                .variant = way.name,
                                .x = sine,
                                .x_name = "sine of the angle",
                                .error = worst / static_cast<double>(epsilon),
                                .error_name = "error of the sine / epsilon",
                                .cost_name = "time / ns"},
                               way, lights, n, eta);
        }
    }
    // Light so close to the critical angle that rounding can decide: how often is the branch wrong?
    for (const int ulps : {1, 2, 4, 8, 16, 1024})
        for (const Refraction& way : refractions) {
            Rng rng{1, 1};
            std::vector<Vec3> lights;
            int wrong = 0;
            const int count = 4096;
            for (int i = 0; i < count; ++i) {
                const Real eta = rng.uniform(Real(1.1), Real(2.5));
                const bool is_total = (i & 1) == 0;
                Real s = 1 / eta;
                for (int k = 0; k < ulps; ++k) s = std::nextafter(s, Real(is_total ? 1 : 0));
                const Vec3 v{s, -std::sqrt((1 - s) * (1 + s)), 0};
                wrong += way.refract(v, {0, 1, 0}, eta).has_value() == is_total;
            }
            const Real eta = Real(1.5);
            Real s = 1 / eta;
            for (int k = 0; k < ulps; ++k) s = std::nextafter(s, Real(0));
            lights.assign(512, {s, -std::sqrt((1 - s) * (1 + s)), 0});
            add_refraction_row(report,
                               {.study = "Critical angle",
                                .variant = way.name,
                                .x = static_cast<double>(ulps),
                                .x_name = "distance / ulp",
                                .error = static_cast<double>(wrong) / count,
                                .error_name = "share of wrong branches",
                                .cost_name = "time / ns"},
                               way, lights, {0, 1, 0}, eta);
        }
    report.time_in_turns();
}

// Three ways to deal with fuzz that points below the surface. Each returns
// nothing for absorbed light.
std::optional<Vec3> fuzz_absorbed(Vec3 incoming, Vec3 normal, Real fuzz, Rng& random) {
    const Vec3 d =
        normalize(reflect(incoming, normal) + fuzz * uniform_direction(random_place(random)));
    if (dot(d, normal) <= 0) return {};
    return d;
}
std::optional<Vec3> fuzz_drawn_again(Vec3 incoming, Vec3 normal, Real fuzz, Rng& random) {
    for (;;)
        if (const auto d = fuzz_absorbed(incoming, normal, fuzz, random)) return d;
}
std::optional<Vec3> fuzz_folded(Vec3 incoming, Vec3 normal, Real fuzz, Rng& random) {
    return metal_direction(incoming, normal, fuzz, random_place(random));
}

void add_fuzz(study::Report& report) {
    struct Way {
        const char* name;
        std::optional<Vec3> (*sample)(Vec3, Vec3, Real, Rng&);
    };
    const std::array<Way, 3> ways{{{"absorbed, classic", fuzz_absorbed},
                                   {"drawn again", fuzz_drawn_again},
                                   {"folded", fuzz_folded}}};
    for (const double degrees : {0.0, 89.9})
        for (const Way& way : ways)
            for (const Real fuzz : scene::fuzz_values) {
                const Real angle = radians(static_cast<Real>(degrees));
                const Vec3 incoming = normalize({std::sin(angle), -std::cos(angle), 0});
                Rng rng{1, 1};
                const int samples = 100'000;
                int out = 0;
                for (int i = 0; i < samples; ++i)
                    out += way.sample(incoming, {0, 1, 0}, fuzz, rng).has_value();
                const int batch = 512;
                const auto sample_many = [=]() mutable {
                    Vec3 sum;
                    for (int i = 0; i < batch; ++i)
                        if (const auto d = way.sample(incoming, {0, 1, 0}, fuzz, rng)) sum += *d;
                    study::keep(sum);
                };
                report.add({.study = degrees > 0 ? "Fuzz at the rim" : "Fuzz head on",
                            .variant = way.name,
                            .x = static_cast<double>(fuzz),
                            .x_name = "fuzz",
                            .error = 1 - static_cast<double>(out) / samples,
                            .error_name = "light lost in the furnace",
                            .cost_name = "time / ns"},
                           sample_many, batch);
            }
    report.time_in_turns();
}

// A small picture as a list of colors.
constexpr int drawn_width = 64, drawn_height = 36;

template <class World, class Materials, class Ending>
std::vector<Color> draw(const World& world, const Materials& materials, const Ending& ending,
                        const View& view, Quality quality) {
    const Camera camera = make_camera(view, drawn_width, drawn_height);
    std::vector<Color> pixels;
    for (int y = 0; y < drawn_height; ++y)
        for (int x = 0; x < drawn_width; ++x)
            pixels.push_back(
                render_pixel(camera, world, materials, scene::EveningSky{}, ending, quality, x, y));
    return pixels;
}

double mean_difference(const std::vector<Color>& a, const std::vector<Color>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += static_cast<double>(std::abs(a[i].g - b[i].g));
    return sum / static_cast<double>(a.size());
}

// Glass in glass: a ball of glass contains a ball of diamond, which contains a bubble. All depths
// use the same random numbers, so the pictures differ only by the paths that were cut off.
void add_depth(study::Report& report) {
    const SphereList world{{{{{0, 0, 0}, 1}, 0},
                            {{{Real(0.1), 0, 0}, Real(0.75)}, 1},
                            {{{Real(0.25), 0, 0}, Real(0.35)}, 2}}};
    const MaterialSet<Dielectric> glass{
        {Dielectric{Real(1.5)}, Dielectric{Real(2.4 / 1.5)}, Dielectric{Real(1 / 2.4)}}};
    const View view{{0, Real(0.3), 4}, {0, 0, 0}, {0, 1, 0}, radians(30)};
    const auto correct = draw(world, glass, BlackEnding{}, view, {4, 2000, 1});
    const auto add = [&](const char* name, int depth, const auto& ending) {
        constexpr int samples = 4;
        const auto draw_again = [&, depth, ending] {
            return draw(world, glass, ending, view, {samples, depth, 1});
        };
        report.add(
            {.study = "Depth limit",
             .variant = name,
             .x = static_cast<double>(depth),
             .x_name = "depth",
             .error = mean_difference(draw_again(), correct),
             .error_name = "mean error of a pixel",
             .cost_name = "time of a path / ns"},
            [draw_again] { study::keep(draw_again()); }, drawn_width * drawn_height * samples);
    };
    for (const int depth : {1, 2, 4, 6, 8, 12, 16, 32, 64}) {
        add("ends in sky", depth, SkyEnding{});
        add("ends in black", depth, BlackEnding{});
    }
    report.time_in_turns();
}

void add_choice_row(study::Report& report, const char* study, const char* variant, int kinds,
                    double difference, double ns) {
    report.add({.study = study,
                .variant = variant,
                .x = static_cast<double>(kinds),
                .x_name = "kinds of material",
                .error = difference,
                .error_name = "difference",
                .cost = ns,
                .cost_name = "time / ns"});
}

// Draws the program's scene twice: with its materials as values, and as objects with a virtual
// function.
void add_choice_in_paths(study::Report& report, const scene::Scene& evening,
                         const classic::Materials& objects) {
    const View view{{0, Real(2.9), 12}, {0, Real(0.85), 0}, {0, 1, 0}, radians(19)};
    const Quality quality{4, 12, 1};
    std::vector<Color> values, classes;
    const auto ns = study::in_turns_ns(
        {[&] { values = draw(evening.world, evening.set, SkyEnding{}, view, quality); },
         [&] { classes = draw(evening.world, objects, SkyEnding{}, view, quality); }},
        {.rounds = 9});
    const int paths = drawn_width * drawn_height * quality.samples_per_pixel;
    add_choice_row(report, "Choice, whole path", "std::variant", 4, 0, ns[0] / paths);
    add_choice_row(report, "Choice, whole path", "virtual", 4, mean_difference(values, classes),
                   ns[1] / paths);
}

// Times the choice alone: nothing but scatter() on a list of hits, which are on metal alone, or on
// all materials of the scene in random order.
void add_choice_alone(study::Report& report, const scene::Scene& evening,
                      const classic::Materials& objects) {
    const auto count = static_cast<int>(evening.set.materials.size());
    const MaterialList<Metal> alone{
        std::vector<Metal>(static_cast<std::size_t>(count), Metal{{1, 1, 1}, Real(0.3)})};
    MaterialSet<Metal, Lambertian> same;
    for (const Metal& metal : alone.materials) same.materials.emplace_back(metal);
    const classic::Materials same_objects = classic::from_values(same);
    Rng order{3, 1};
    std::vector<Hit> hits(1024);
    for (Hit& hit : hits) {
        hit.normal = {0, 1, 0};
        hit.material = static_cast<int>(order() % static_cast<unsigned>(count));
    }
    const auto scatter_all = [&hits](const auto& materials) -> study::Work {
        return [&hits, &materials, random = Rng{1, 1}]() mutable {
            const Vec3 incoming = normalize({1, -1, 0});
            Vec3 sum;
            for (const Hit& hit : hits)
                if (const auto bounce = materials(incoming, hit, random)) sum += bounce->direction;
            study::keep(sum);
        };
    };
    const auto ns =
        study::in_turns_ns({scatter_all(alone), scatter_all(same), scatter_all(same_objects),
                            scatter_all(evening.set), scatter_all(objects)},
                           {.rounds = 9, .at_least_ms = 1});
    const auto add = [&](const char* variant, int kinds, std::size_t i) {
        add_choice_row(report, "Choice alone", variant, kinds, 0,
                       ns[i] / static_cast<double>(hits.size()));
    };
    add("one type", 1, 0);
    add("std::variant", 1, 1);
    add("virtual", 1, 2);
    add("std::variant", 4, 3);
    add("virtual", 4, 4);
}

void add_choice(study::Report& report) {
    const scene::Scene evening = scene::evening();
    const classic::Materials objects = classic::from_values(evening.set);
    add_choice_in_paths(report, evening, objects);
    add_choice_alone(report, evening, objects);
}

void run(study::Report& report) {
    add_reflectance(report);
    add_refraction(report);
    add_fuzz(report);
    add_depth(report);
    add_choice(report);
    add_pixel_errors(report);
}

}  // namespace
}  // namespace metal_glass_study

void (*const app::program_study)(study::Report&) = metal_glass_study::run;
