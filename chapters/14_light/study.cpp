// Measures the noise of the ways to find a lamp: samples, bounces and both, on plates of all kinds;
// points spread over a triangle's area against directions spread over its solid angle; and the time
// that it takes to choose an entry of a table.

#include <app/run.hpp>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <rt/hit_sphere.hpp>
#include <rt/lobe.hpp>
#include <rt/rng.hpp>
#include <rt/running_shares.hpp>
#include <rt/sphere_light.hpp>
#include <rt/triangle_light.hpp>
#include <rt/way_weight.hpp>
#include <string>
#include <study/report.hpp>

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
            for (std::size_t k = 0; k < all.size(); ++k) {
                // Where a way finds nothing at all, nothing is known of its error.
                if (!(found[k].mean() > 0)) continue;
                const Real error = static_cast<Real>(std::sqrt(found[k].squares / found[k].count -
                                                               found[k].mean() * found[k].mean()) /
                                                     found[3].mean());
                char name[40];
                std::snprintf(name, sizeof name, "plate %g", static_cast<double>(spread));
                report.add({name, names[k], static_cast<double>(radius), "radius of the lamp",
                            static_cast<double>(error), "relative error of one sample"});
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

void run_study(study::Report& report) {
    study_plates(report);
    study_triangle(report);
    study_table(report);
}

}  // namespace
}  // namespace light

void (*const app::program_study)(study::Report&) = light::run_study;
