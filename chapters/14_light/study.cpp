// Measures the noise of the ways to find a lamp: samples, bounces and both, on plates of all kinds;
// points spread over a triangle's area against directions spread over its solid angle; the time
// that it takes to choose an entry of a table; lamps chosen by power or by a tree; a sky sampled
// evenly or by its picture; and the facets of rough metal.

#include <algorithm>
#include <app/run.hpp>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <rt/choose_lamp.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/lobe.hpp>
#include <rt/rng.hpp>
#include <rt/rough_metal.hpp>
#include <rt/running_shares.hpp>
#include <rt/sky_picture.hpp>
#include <rt/sphere_light.hpp>
#include <rt/triangle_light.hpp>
#include <rt/way_weight.hpp>
#include <string>
#include <study/report.hpp>
#include <study/timing.hpp>

#include "alias_table.hpp"
#include "spherical_triangle.hpp"

namespace light {
namespace {

using namespace rt;

// The mean and the spread of numbers, in double.
struct Spread {
    double count = 0, sum = 0, squares = 0;
    void add(double x) {
        count += 1;
        sum += x;
        squares += x * x;
    }
    double mean() const { return sum / count; }
    // The root mean square distance from the mean, relative to it.
    double relative() const {
        return std::sqrt(std::max(0.0, squares / count - mean() * mean())) / mean();
    }
};

// The nanoseconds that one sample, one bounce or one of each takes, twice: for both heuristics.
// Each asks whether its ray meets the lamp.
std::vector<double> times_of_ways(const Lobe& plate, const Sphere& lamp, Vec3 incoming,
                                  const Hit& hit) {
    constexpr int count = 200;
    const auto of_samples = [=](Rng& random) {
        const auto sample = sample_light(lamp, {}, random_place(random));
        study::keep(scatter_density(plate, incoming, hit, sample->direction));
        study::keep(hit_sphere(lamp, Ray{{}, sample->direction}, {0, infinity}));
    };
    const auto of_bounces = [=](Rng& random) {
        const auto bounce = scatter(plate, incoming, hit, random);
        study::keep(scatter_density(plate, incoming, hit, bounce->direction));
        study::keep(hit_sphere(lamp, Ray{{}, bounce->direction}, {0, infinity}));
    };
    const auto many = [](auto one) {
        return [one] {
            Rng random{14, 6};
            for (int i = 0; i < count; ++i) one(random);
        };
    };
    const auto both = [=](Ways ways) {
        return many([=](Rng& random) {
            of_samples(random);
            of_bounces(random);
            study::keep(way_weight(ways, Way::sample, 2 + random.uniform(), 1));
            study::keep(way_weight(ways, Way::bounce, 2 + random.uniform(), 1));
        });
    };
    std::vector<double> times = study::in_turns_ns(
        {many(of_samples), many(of_bounces), both(Ways::balance), both(Ways::power)},
        {.rounds = 11, .at_least_ms = 0.5});
    for (double& time : times) time /= count;
    return times;
}

// A plate at the origin, and a lamp in the middle of what it mirrors: as in plates.hpp, but each
// lamp alone. The error is that of the light that one sample, one bounce or one of each finds.
void study_plates(study::Report& report) {
    const Vec3 incoming = normalize({1, -1, 0});
    Hit hit;
    hit.normal = {0, 1, 0};
    hit.front = true;
    for (const Real spread : {Real(0.006), Real(0.025), Real(0.08), Real(0.2)})
        for (const Real radius : {Real(0.0333), Real(0.1), Real(0.3), Real(0.9)}) {
            const Lobe plate{{1, 1, 1}, 1 / (spread * spread)};
            const Sphere lamp{4 * normalize({1, 1, 0}), radius};
            const Real of_samples = light_density(lamp, {});
            Rng random{14, 2};
            std::array<Spread, 4> found;
            constexpr std::array<Ways, 4> all{Ways::samples, Ways::bounces, Ways::balance,
                                              Ways::power};
            for (int i = 0; i < 200'000; ++i) {
                const auto sample = sample_light(lamp, {}, random_place(random));
                const auto bounce = scatter(plate, incoming, hit, random);
                if (!sample || !bounce) continue;
                const Real toward = scatter_density(plate, incoming, hit, sample->direction);
                const Real drawn = scatter_density(plate, incoming, hit, bounce->direction);
                const bool meets =
                    hit_sphere(lamp, Ray{{}, bounce->direction}, {0, infinity}).has_value();
                for (std::size_t k = 0; k < all.size(); ++k) {
                    Real light = 0;
                    if (toward > 0)
                        light += toward / sample->density *
                                 way_weight(all[k], Way::sample, sample->density, toward);
                    if (meets) light += way_weight(all[k], Way::bounce, drawn, of_samples);
                    found[k].add(static_cast<double>(light));
                }
            }
            constexpr std::array<const char*, 4> names{"samples", "bounces", "balance", "power"};
            const std::vector<double> times = times_of_ways(plate, lamp, incoming, hit);
            for (std::size_t k = 0; k < all.size(); ++k) {
                // Where a way finds nothing at all, nothing is known of its error.
                if (!(found[k].mean() > 0)) continue;
                const Real error = static_cast<Real>(std::sqrt(found[k].squares / found[k].count -
                                                               found[k].mean() * found[k].mean()) /
                                                     found[3].mean());
                char name[40];
                std::snprintf(name, sizeof name, "plate %g", static_cast<double>(spread));
                study::Row row{name,
                               names[k],
                               static_cast<double>(radius),
                               "radius of the lamp",
                               static_cast<double>(error),
                               "relative error of one sample"};
                // Of independent samples, the squared error falls as the time grows.
                if (error > 0) {
                    row.cost = row.error * row.error / 1e-4 * times[k] / 1000;
                    row.cost_name = "time for an error of 1 % / us";
                }
                report.add(row);
            }
        }
}

// A floor below a triangle that faces it: points spread over the area, or directions over the solid
// angle.
void study_triangle(study::Report& report) {
    for (const Real distance : {Real(0.05), Real(0.2), Real(1), Real(3), Real(10)}) {
        const Triangle lamp{{Real(-0.5), distance, Real(-0.3)},
                            {Real(0.5), distance, Real(-0.3)},
                            {0, distance, Real(0.6)}};
        const SphericalTriangle seen{lamp, {}};
        Rng random{14, 3};
        Spread by_area, by_angle;
        std::vector<Vec2> places;
        for (int i = 0; i < 20'000; ++i) {
            const Vec2 place = random_place(random);
            if (places.size() < 1000) places.push_back(place);
            if (const auto sample = sample_light(lamp, {}, place))
                by_area.add(static_cast<double>(sample->direction.y / sample->density));
            by_angle.add(static_cast<double>(seen.direction(place).y) * seen.solid_angle());
        }
        const auto x = static_cast<double>(distance);
        report.add(
            {"triangle", "area", x, "distance / size", by_area.relative(),
             "relative error of one sample", 0, "time per sample / ns"},
            [lamp, places] {
                for (const Vec2 place : places) study::keep(sample_light(lamp, {}, place));
            },
            static_cast<double>(places.size()));
        report.add(
            {"triangle", "solid angle", x, "distance / size", by_angle.relative(),
             "relative error of one sample", 0, "time per sample / ns"},
            [lamp, places] {
                for (const Vec2 place : places)
                    study::keep(SphericalTriangle{lamp, {}}.direction(place));
            },
            static_cast<double>(places.size()));
    }
    report.time_in_turns();
}

// Choosing an entry, by bisection and by an alias table.
void study_table(study::Report& report) {
    for (const std::size_t count : {std::size_t{10}, std::size_t{1000}, std::size_t{100'000}}) {
        Rng random{14, 4};
        std::vector<Real> weights, numbers;
        for (std::size_t i = 0; i < count; ++i) weights.push_back(random.uniform(1, 9));
        for (int i = 0; i < 1000; ++i) numbers.push_back(random.uniform());
        const auto shares = running_shares(weights);
        const AliasTable alias{weights};
        const auto x = static_cast<double>(count);
        report.add(
            {"table", "bisection", x, "entries", 0, "", 0, "time per choice / ns"},
            [shares, numbers] {
                for (const Real number : numbers) study::keep(pick(shares, number).index);
            },
            static_cast<double>(numbers.size()));
        report.add(
            {"table", "alias", x, "entries", 0, "", 0, "time per choice / ns"},
            [alias, numbers] {
                for (const Real number : numbers) study::keep(alias.pick(number));
            },
            static_cast<double>(numbers.size()));
    }
    report.time_in_turns();
}

// A floor below a square of lamps at distance 1 from each other. What one sample of one lamp finds
// is known exactly for each lamp, and so is its error.
void study_lamps(study::Report& report) {
    for (const int side : {3, 10, 32, 100}) {
        Rng random{14, 7};
        std::vector<Sphere> lamps;
        std::vector<Box> boxes;
        std::vector<Real> powers;
        for (int i = 0; i < side * side; ++i) {
            const Vec3 center{static_cast<Real>(i % side) + random.uniform(),
                              random.uniform(Real(0.25), Real(0.4)), static_cast<Real>(i / side)};
            lamps.push_back({center, random.uniform(Real(0.015), Real(0.04))});
            boxes.push_back(bounds_of(lamps.back()));
            powers.push_back(lamps.back().radius * lamps.back().radius);
        }
        const LampTree tree = make_lamp_tree(boxes, powers);
        std::vector<Vec3> points;
        std::vector<Real> numbers;
        double squares_of_list = 0, squares_of_tree = 0;
        constexpr int count = 100;
        for (int i = 0; i < count; ++i) {
            const Vec3 from{random.uniform() * static_cast<Real>(side), 0,
                            random.uniform() * static_cast<Real>(side)};
            points.push_back(from);
            numbers.push_back(random.uniform());
            double all = 0, by_list = 0, by_tree = 0;
            for (std::size_t lamp = 0; lamp < lamps.size(); ++lamp) {
                const Vec3 apart = lamps[lamp].center - from;
                const Real squared = dot(apart, apart);
                const auto light =
                    static_cast<double>(powers[lamp] * apart.y / (squared * std::sqrt(squared)));
                all += light;
                by_list += light * light / static_cast<double>(probability_of(tree.shares, lamp));
                by_tree += light * light / static_cast<double>(lamp_probability(tree, from, lamp));
            }
            squares_of_list += by_list / (all * all) - 1;
            squares_of_tree += by_tree / (all * all) - 1;
        }
        const auto x = static_cast<double>(lamps.size());
        report.add(
            {"lamps", "list", x, "lamps", std::sqrt(squares_of_list / count),
             "relative error of one sample", 0, "time per sample / ns"},
            [=] {
                for (std::size_t i = 0; i < points.size(); ++i)
                    study::keep(sample_light(lamps[pick(tree.shares, numbers[i]).index], points[i],
                                             {Real(0.3), Real(0.6)}));
            },
            count);
        report.add(
            {"lamps", "tree", x, "lamps", std::sqrt(squares_of_tree / count),
             "relative error of one sample", 0, "time per sample / ns"},
            [=] {
                for (std::size_t i = 0; i < points.size(); ++i)
                    study::keep(sample_light(lamps[choose_lamp(tree, points[i], numbers[i]).index],
                                             points[i], {Real(0.3), Real(0.6)}));
            },
            count);
    }
    report.time_in_turns();
}

// A floor below a white sky, in which one pixel is brighter than the others by a factor. The light
// of the floor, by directions that are equally likely everywhere, or likely where light comes from.
void study_sky(study::Report& report) {
    for (const Real sun : {Real(1), Real(100), Real(10'000), Real(1'000'000)}) {
        Image picture{64, 32, {1, 1, 1}};
        picture.at(20, 8) = {sun, sun, sun};
        const SkyTable table = make_sky_table(picture);
        const auto light_from = [&picture](Vec3 direction) {
            const SkyPixel pixel = sky_pixel(picture, direction);
            return std::max(direction.y, Real(0)) * picture.at(pixel.column, pixel.row).r;
        };
        Rng random{14, 8};
        Spread evenly, by_picture;
        std::vector<Vec2> places;
        for (int i = 0; i < 400'000; ++i) {
            const Vec2 place = random_place(random);
            if (places.size() < 1000) places.push_back(place);
            evenly.add(static_cast<double>(light_from(uniform_direction(place)) * 4 * pi));
            if (const auto sample = sample_sky(table, place))
                by_picture.add(
                    static_cast<double>(light_from(sample->direction) / sample->density));
        }
        const auto x = static_cast<double>(sun);
        report.add(
            {"sky", "evenly", x, "brightness of the sun", evenly.relative(),
             "relative error of one sample", 0, "time per sample / ns"},
            [places] {
                for (const Vec2 place : places) study::keep(uniform_direction(place));
            },
            static_cast<double>(places.size()));
        report.add(
            {"sky", "by its picture", x, "brightness of the sun", by_picture.relative(),
             "relative error of one sample", 0, "time per sample / ns"},
            [&table, places] {
                for (const Vec2 place : places) study::keep(sample_sky(table, place));
            },
            static_cast<double>(places.size()));
        report.time_in_turns();
    }
}

// White rough metal under a white sky, seen at 75 degrees: facets that are drawn by how they face
// alone, or by how large they are seen. And how much light is lost, in a single bounce and with
// what comes back from several.
void study_metal(study::Report& report) {
    const Real cosine = portable::cos(75 * pi / 180);
    const Vec3 out{std::sqrt(1 - cosine * cosine), 0, cosine};
    for (const Real alpha : {Real(0.01), Real(0.1), Real(0.3), Real(1)}) {
        // The share of facets that are seen from a direction: 1 less what hides them.
        const auto seen = [alpha](Vec3 v) {
            return 2 * v.z / (v.z + std::sqrt(v.z * v.z + alpha * alpha * (v.x * v.x + v.y * v.y)));
        };
        const auto any_facet = [alpha](Vec2 place) {
            const Real tangent = alpha * std::sqrt(place.x / (1 - place.x));
            const auto turn = sine_cosine_of_turn(place.y);
            return normalize(Vec3{tangent * turn.cosine, tangent * turn.sine, 1});
        };
        const auto of_any = [=](Vec3 facet) {
            const Real toward = dot(out, facet);
            if (!(toward > 0)) return Real(0);
            const Vec3 in = mirrored_at(out, facet);
            return kept_from(out, in, alpha) * seen(out) * toward / (out.z * facet.z);
        };
        Rng random{14, 9};
        Spread all_facets, visible;
        std::vector<Vec2> places;
        for (int i = 0; i < 200'000; ++i) {
            const Vec2 place = random_place(random);
            if (places.size() < 1000) places.push_back(place);
            all_facets.add(static_cast<double>(of_any(any_facet(place))));
            visible.add(static_cast<double>(
                kept_from(out, mirrored_at(out, visible_facet(out, alpha, place)), alpha)));
        }
        const auto x = static_cast<double>(alpha);
        report.add(
            {"facets", "all", x, "alpha", all_facets.relative(), "relative error of one sample", 0,
             "time per sample / ns"},
            [=] {
                for (const Vec2 place : places) study::keep(of_any(any_facet(place)));
            },
            static_cast<double>(places.size()));
        report.add(
            {"facets", "visible", x, "alpha", visible.relative(), "relative error of one sample", 0,
             "time per sample / ns"},
            [=] {
                for (const Vec2 place : places)
                    study::keep(
                        kept_from(out, mirrored_at(out, visible_facet(out, alpha, place)), alpha));
            },
            static_cast<double>(places.size()));
        const RoughMetal metal = make_rough_metal({1, 1, 1}, std::sqrt(alpha));
        const Real factor = compensation(metal.color, kept_at(metal, cosine)).r;
        report.add({"white furnace", "one bounce", x, "alpha", std::abs(1 - visible.mean()),
                    "share of light lost"});
        report.add({"white furnace", "compensated", x, "alpha",
                    std::abs(1 - visible.mean() * static_cast<double>(factor)),
                    "share of light lost"});
    }
    report.time_in_turns();
}

void run_study(study::Report& report) {
    study_plates(report);
    study_triangle(report);
    study_table(report);
    study_lamps(report);
    study_sky(report);
    study_metal(report);
}

}  // namespace
}  // namespace light

void (*const app::program_study)(study::Report&) = light::run_study;
