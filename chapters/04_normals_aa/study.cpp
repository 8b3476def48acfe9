// What accuracy costs: all errors on one scale; more samples, better placed samples, and more
// bounces.

#include <app/run.hpp>
#include <cmath>
#include <functional>
#include <study/pixel_error.hpp>
#include <study/report.hpp>
#include <study/timing.hpp>

#include "error_budget.hpp"
#include "stage.hpp"

namespace normals_aa {
namespace {

double mean_radiance(const Pixels& pixels) {
    double sum = 0;
    for (const Color& c : pixels) sum += static_cast<double>(c.r + c.g + c.b);
    return sum / (3 * static_cast<double>(pixels.size()));
}

// A way to place the samples of a pixel.
struct Placement {
    const char* variant;
    int samples;                    // per pixel
    std::function<double()> judge;  // draws anew, and returns the mean squared error of a pixel
    double sum = 0, calls = 0;      // of what judge() returned

    double error() const { return std::sqrt(sum / calls); }
};

// Times the placements in turns, and adds a row for each. They must come in threes, each three with
// the same number of samples: independent ones, jittered ones, and those of Sobol's sequence. For
// each three, a fourth row gives the error that the square-root law predicts for independent
// samples. The cost is the time of judge() divided by `parts(samples)`.
template <class Parts>
void add_placements(study::Report& report, std::vector<Placement> placements,
                    const study::Row& names, const study::Turns& turns, Parts parts) {
    std::vector<study::Work> works;
    for (Placement& placement : placements)
        works.push_back([&placement] { placement.sum += placement.judge(), ++placement.calls; });
    const std::vector<double> ns = study::in_turns_ns(works, turns);
    const auto add = [&](const char* variant, int samples, double error, double time) {
        study::Row row = names;
        row.variant = variant;
        row.x = static_cast<double>(samples);
        row.error = error;
        row.cost = time / parts(samples);
        report.add(row);
    };
    for (std::size_t i = 0; i < placements.size(); i += 3) {
        const int samples = placements[i].samples;
        for (std::size_t k = i; k < i + 3; ++k)
            add(placements[k].variant, samples, placements[k].error(), ns[k]);
        add("1 / sqrt(N)", samples, placements[0].error() / std::sqrt(samples), ns[i]);
    }
}

void study_samples(study::Report& report, const Stage& stage) {
    constexpr int depth = 4;
    const Pixels reference = draw_low_discrepancy(stage, 1 << 14, depth, 1, SkyEnding{});
    std::vector<Placement> placements;
    const auto add = [&](const char* variant, int samples, auto draw) {
        const auto judge = [&reference, draw, seed = std::uint64_t{100}]() mutable {
            const double error = study::root_mean_square_error(draw(seed++), reference);
            return error * error;
        };
        placements.push_back({variant, samples, judge});
    };
    for (int n = 1; n <= 1024; n *= 4) {
        add("independent", n,
            [&stage, n](auto seed) { return draw_independent(stage, n, depth, seed); });
        add("jittered in the pixel", n, [&stage, n](auto seed) {
            return draw_jittered(stage, {n, depth, seed}, SkyEnding{});
        });
        add("Owen-scrambled Sobol", n, [&stage, n](auto seed) {
            return draw_low_discrepancy(stage, n, depth, seed, SkyEnding{});
        });
    }
    add_placements(report, placements,
                   {.study = "Samples",
                    .x_name = "samples per pixel",
                    .error_name = "RMSE of a pixel",
                    .cost_name = "time / ms"},
                   {.rounds = 5}, [](int) { return 1e6; });
}

// The exact share of a pixel that lies on one side of a straight edge, where
// x * cosine + y * sine < edge. Cosine and sine must be greater than 0.
double coverage(double cosine, double sine, double edge) {
    const auto triangle = [&](double e) { return e > 0 ? e * e / (2 * cosine * sine) : 0; };
    return triangle(edge) - triangle(edge - cosine) - triangle(edge - sine) +
           triangle(edge - cosine - sine);
}

// The same three placements, where only the sample point in the pixel is random.
void study_edge(study::Report& report) {
    constexpr int edges = 1000;
    std::vector<Placement> placements;
    const auto add = [&](const char* variant, int samples, auto average) {
        const auto judge_all = [average] {
            Rng choose{4, 2};
            double sum = 0;
            for (int i = 0; i < edges; ++i) {
                const Real angle = choose.uniform(Real(0.1), Real(1.4));
                const Real c = std::cos(angle), s = std::sin(angle);
                const Real edge = (c + s) * choose.uniform();
                const double share = static_cast<double>(average(
                    i, [&](Vec2 at) { return at.x * c + at.y * s < edge ? Color{1} : Color{}; }));
                const double error =
                    share - coverage(static_cast<double>(c), static_cast<double>(s),
                                     static_cast<double>(edge));
                sum += error * error;
            }
            return sum / edges;
        };
        placements.push_back({variant, samples, judge_all});
    };
    for (int n = 1; n <= 1024; n *= 4) {
        add("independent", n, [n](int i, auto covered) {
            Rng random = pixel_rng(1, i, n);
            Color sum;
            for (int k = 0; k < n; ++k) sum += covered(random_place(random));
            return sum.r / static_cast<Real>(n);
        });
        add("jittered in the pixel", n, [n](int i, auto covered) {
            Rng random = pixel_rng(2, i, n);
            return pixel_average(n, random, covered).r;
        });
        add("Owen-scrambled Sobol", n, [n](int i, auto covered) {
            Color sum;
            for (int k = 0; k < n; ++k) {
                LowDiscrepancy random{3, i, n, k};
                sum += covered(random_place(random));
            }
            return sum.r / static_cast<Real>(n);
        });
    }
    add_placements(report, placements,
                   {.study = "Edge",
                    .x_name = "samples per pixel",
                    .error_name = "RMSE of a pixel",
                    .cost_name = "time per sample / ns"},
                   {.rounds = 9, .at_least_ms = 1}, [](int samples) { return edges * samples; });
}

// How far the mean radiance with each ending is from that of paths that may bounce 64 times: too
// bright with the sky, too dark with black. With every ending, the paths are the same up to the
// depth limit, so that their shared noise cancels; only the roulette draws random numbers of its
// own.
void study_depth(study::Report& report, const Stage& stage) {
    constexpr int samples = 1024;
    const auto draw = [&](int depth, const auto& ending) {
        return draw_low_discrepancy(stage, samples, depth, 1, ending);
    };
    const double reference = mean_radiance(draw(64, SkyEnding{}));
    const auto add = [&](const char* variant, int depth, const auto& ending) {
        const double mean = mean_radiance(draw(depth, ending));
        report.add(
            {.study = "Depth limit",
             .variant = variant,
             .x = static_cast<double>(depth),
             .x_name = "most bounces",
             .error = 100 * std::abs(mean / reference - 1),
             .error_name = "mean radiance off / %",
             .cost_name = "time / ms"},
            [draw, depth, ending] { study::keep(draw(depth, ending)); }, 1e6);
    };
    for (const int depth : {1, 2, 3, 4, 6, 8, 16}) {
        add("sky", depth, SkyEnding{});
        add("black", depth, BlackEnding{});
        add("Russian roulette", depth, RouletteEnding{});
    }
    report.time_in_turns({.rounds = 3});
}

void study_samples_and_depth(study::Report& report) {
    const Stage stage;
    study_budget(report);
    study_edge(report);
    study_samples(report, stage);
    study_depth(report, stage);
}

}  // namespace
}  // namespace normals_aa

void (*const app::program_study)(study::Report&) = normals_aa::study_samples_and_depth;
