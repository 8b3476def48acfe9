#pragma once
// What accuracy costs: all errors on one scale; more samples, better placed samples, and more
// bounces.

#include <cmath>
#include <study/pixel_error.hpp>
#include <study/report.hpp>
#include <study/timing.hpp>

#include "error_budget.hpp"
#include "stage.hpp"

namespace normals_aa {

inline double mean_radiance(const Pixels& pixels) {
    double sum = 0;
    for (const Color& c : pixels) sum += static_cast<double>(c.r + c.g + c.b);
    return sum / (3 * static_cast<double>(pixels.size()));
}

// The root mean square error of a pixel, over several seeds, and the median time of a picture.
struct Measured {
    double error, cost;
};
template <class Draw>
Measured measure(const Pixels& reference, Draw draw) {
    constexpr int seeds = 5;
    std::uint64_t seed = 100;
    double sum = 0;
    const auto judge = [&] {
        const double error = study::root_mean_square_error(draw(seed++), reference);
        sum += error * error;
    };
    const double ns = study::time_ns(judge, {.rounds = seeds});
    return {std::sqrt(sum / seeds), 1e-6 * ns};
}

inline void study_samples(study::Report& report, const Stage& stage) {
    constexpr int depth = 4;
    const Pixels reference = draw_low_discrepancy(stage, 1 << 14, depth, 1, SkyEnding{});
    const auto add = [&](const char* variant, int samples, Measured m) {
        report.add({.study = "Samples",
                    .variant = variant,
                    .x = static_cast<double>(samples),
                    .x_name = "samples per pixel",
                    .error = m.error,
                    .error_name = "RMSE of a pixel",
                    .cost = m.cost,
                    .cost_name = "time / ms"});
    };
    double first = 0;
    for (int n = 1; n <= 1024; n *= 4) {
        const Measured independent = measure(
            reference, [&](std::uint64_t seed) { return draw_independent(stage, n, depth, seed); });
        if (n == 1) first = independent.error;
        add("independent", n, independent);
        add("jittered in the pixel", n, measure(reference, [&](std::uint64_t seed) {
                return draw_jittered(stage, {n, depth, seed}, SkyEnding{});
            }));
        add("Owen-scrambled Sobol", n, measure(reference, [&](std::uint64_t seed) {
                return draw_low_discrepancy(stage, n, depth, seed, SkyEnding{});
            }));
        add("1 / sqrt(N)", n, {first / std::sqrt(n), independent.cost});
    }
}

// A pixel that a straight edge cuts: the share of it where x cos + y sin < edge, exactly. Cosine
// and sine must be greater than 0.
inline double coverage(double cosine, double sine, double edge) {
    const auto triangle = [&](double e) { return e > 0 ? e * e / (2 * cosine * sine) : 0; };
    return triangle(edge) - triangle(edge - cosine) - triangle(edge - sine) +
           triangle(edge - cosine - sine);
}

// The same three ways where only the sample point in the pixel is random.
inline void study_edge(study::Report& report) {
    constexpr int edges = 1000;
    const auto add_row = [&](const char* variant, int samples, Measured m) {
        report.add({.study = "Edge",
                    .variant = variant,
                    .x = static_cast<double>(samples),
                    .x_name = "samples per pixel",
                    .error = m.error,
                    .error_name = "RMSE of a pixel",
                    .cost = m.cost,
                    .cost_name = "time per sample / ns"});
    };
    const auto add = [&](const char* variant, int samples, auto average) {
        double sum = 0;
        const auto judge_all = [&] {
            Rng choose{4, 2};
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
        };
        const double ns = study::time_ns(judge_all, {.rounds = 1});
        const Measured m{std::sqrt(sum / edges), ns / edges / samples};
        add_row(variant, samples, m);
        return m;
    };
    double first = 0;
    for (int n = 1; n <= 1024; n *= 4) {
        const Measured independent = add("independent", n, [n](int i, auto covered) {
            Rng random = pixel_rng(1, i, n);
            Color sum;
            for (int k = 0; k < n; ++k) sum += covered(random_place(random));
            return sum.r / static_cast<Real>(n);
        });
        if (n == 1) first = independent.error;
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
        add_row("1 / sqrt(N)", n, {first / std::sqrt(n), independent.cost});
    }
}

// How far the mean radiance with each ending is from that of paths that may bounce 64 times: too
// bright with the sky, too dark with black. All follow the same paths up to their limit, so that
// the noise that they share cancels; only the roulette draws random numbers of its own.
inline void study_depth(study::Report& report, const Stage& stage) {
    constexpr int samples = 1024;
    const auto draw = [&](int depth, const auto& ending) {
        return draw_low_discrepancy(stage, samples, depth, 1, ending);
    };
    const double reference = mean_radiance(draw(64, SkyEnding{}));
    const auto add = [&](const char* variant, int depth, const auto& ending) {
        double mean = 0;
        const double ns =
            study::time_ns([&] { mean = mean_radiance(draw(depth, ending)); }, {.rounds = 1});
        report.add({.study = "Depth limit",
                    .variant = variant,
                    .x = static_cast<double>(depth),
                    .x_name = "most bounces",
                    .error = 100 * std::abs(mean / reference - 1),
                    .error_name = "mean radiance off / %",
                    .cost = 1e-6 * ns,
                    .cost_name = "time / ms"});
    };
    for (const int depth : {1, 2, 3, 4, 6, 8, 16}) {
        add("sky", depth, SkyEnding{});
        add("black", depth, BlackEnding{});
        add("Russian roulette", depth, RouletteEnding{});
    }
}

inline void study_samples_and_depth(study::Report& report) {
    const Stage stage;
    study_budget(report);
    study_edge(report);
    study_samples(report, stage);
    study_depth(report, stage);
}

}  // namespace normals_aa
