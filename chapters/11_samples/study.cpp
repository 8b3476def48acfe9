// Measures the cost and the worth of each way to take samples, and of each rule for stopping.

#include <app/run.hpp>
#include <rt/standard_error.hpp>
#include <study/pixel_error.hpp>
#include <study/report.hpp>
#include <study/timing.hpp>

#include "features.hpp"
#include "scene.hpp"
#include "ways.hpp"

namespace samples {
namespace {

double rmse(const Image& a, const Image& b) {
    return study::root_mean_square_error(a.pixels(), b.pixels());
}

// The chapter's scene in a picture of some size. Only its part `window` is drawn.
struct Stage {
    SceneDescription description = make_scene(scene_view());
    Tile window;
    ReadyScene<scene_effects> ready;
    Renderer<scene_effects> renderer;

    Stage(int width, int height, const Tile& seen)
        : window{seen},
          ready{description, width, height},
          renderer{description, width, height, {1, 8, 1}} {}

    // shade(column, row) draws a pixel of the picture.
    template <class Pixel, class Shade>
    Canvas<Pixel> draw(const Shade& shade) const {
        Canvas<Pixel> canvas{window.right - window.left, window.bottom - window.top};
        for_each_pixel(window, [&](int x, int y) {
            canvas.at(x - window.left, y - window.top) = shade(x, y);
        });
        return canvas;
    }
    template <class Samples>
    Image draw_with(const Samples& samples) const {
        std::uint64_t rays = 0;
        return draw<Color>([&](int x, int y) { return renderer(samples, x, y, rays); });
    }
};

// A picture, and its error, estimated from its own samples.
struct Judged {
    Image image;
    double estimate = 0;
};

template <class Samples>
Judged draw_watched(const Stage& stage, const Samples& samples) {
    double sum = 0;
    std::array<RunningVariance, 3> known;
    std::uint64_t rays = 0;
    Judged judged;
    judged.image = stage.draw<Color>([&](int x, int y) {
        known = {};
        const Color color = stage.renderer(WatchedSamples<Samples>{samples, known}, x, y, rays);
        for (const RunningVariance& channel : known)
            sum += std::pow(static_cast<double>(standard_error(channel)), 2);
        return color;
    });
    judged.estimate = std::sqrt(sum / (3 * static_cast<double>(judged.image.pixels().size())));
    return judged;
}

// The stage's window must be the whole picture.
Judged draw_twins(const Stage& stage, int samples, std::uint64_t seed) {
    const TileGrid grid{stage.window.right, stage.window.bottom, 4};
    const Refined refined =
        refine(grid, seed, samples, [&](int count) { return sobol_passes(stage.renderer, count); });
    return {refined.image, refined.error};
}

// How the error depends on the number of samples, and how well each way estimates its own error.
void study_samples(study::Report& report) {
    const Stage stage{64, 36, {0, 0, 64, 36}};
    const Image truth = stage.draw_with(SobolSamples{77, 2048});
    using Draw = Judged (*)(const Stage&, int samples, std::uint64_t seed);
    constexpr std::array<std::pair<const char*, Draw>, 4> ways{
        {{"independent",
          [](const Stage& in, int samples, std::uint64_t seed) {
              return draw_watched(in, IndependentSamples{seed, samples});
          }},
         {"jittered",
          [](const Stage& in, int samples, std::uint64_t seed) {
              return draw_watched(in, JitteredSamples{seed, samples});
          }},
         {"Sobol",
          [](const Stage& in, int samples, std::uint64_t seed) {
              return draw_watched(in, SobolSamples{seed, samples});
          }},
         {"Sobol in twin halves", draw_twins}}};
    // A picture per round, each with a seed of its own.
    struct Trial {
        const char* variant;
        int samples;
        Draw draw;
        std::uint64_t seed = 1;
        double squares = 0, estimates = 0;
    };
    std::vector<Trial> trials;
    for (const auto& [name, draw] : ways)
        for (int samples = 4; samples <= 256; samples *= 4) trials.push_back({name, samples, draw});
    std::vector<study::Work> works;
    for (Trial& trial : trials)
        works.push_back([&] {
            const Judged one = trial.draw(stage, trial.samples, trial.seed++);
            trial.squares += std::pow(rmse(one.image, truth), 2);
            trial.estimates += std::pow(one.estimate, 2);
        });
    constexpr int rounds = 5;
    const auto ns = study::in_turns_ns(works, {.rounds = rounds});
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const Trial& trial = trials[i];
        const double x = trial.samples, ms = 1e-6 * ns[i];
        report.add({"Samples", trial.variant, x, "samples per pixel",
                    std::sqrt(trial.squares / rounds), "RMSE in a pixel", ms, "time / ms"});
        report.add({"Estimate", trial.variant, x, "samples per pixel",
                    std::sqrt(trial.estimates / trial.squares), "estimated error / error", ms,
                    "time / ms"});
    }
}

// A sample of a pixel where one path in ten finds a lamp.
Real lamp_or_dark(Rng& random) {
    return random.uniform() < Real(0.1) ? 10 : 0;
}
constexpr double lamp_mean = 1;
constexpr Real wanted_error = Real(0.2);
constexpr int most_samples = 4096;

// The mean that a stopping rule leads to, and the number of samples that it took.
struct Stop {
    double mean = 0, samples = 0;
};

RunningVariance draw_lamps(Rng& random, std::int64_t count) {
    RunningVariance known;
    for (std::int64_t i = 0; i < count; ++i) add(known, lamp_or_dark(random));
    return known;
}
Stop to_stop(const RunningVariance& known) {
    return {static_cast<double>(known.mean), static_cast<double>(known.count)};
}

// Stops as soon as the error estimated from the samples is small enough.
Stop stop_by_own_error(Rng& random, int pilot) {
    RunningVariance known = draw_lamps(random, pilot);
    while (known.count < most_samples && standard_error(known) > wanted_error)
        add(known, lamp_or_dark(random));
    return to_stop(known);
}
// Stops after as many samples as the pilot's samples ask for.
Stop stop_by_own_pilot(Rng& random, int pilot) {
    RunningVariance known = draw_lamps(random, pilot);
    const std::int64_t count = samples_for(variance(known), wanted_error, most_samples);
    while (known.count < count) add(known, lamp_or_dark(random));
    return to_stop(known);
}
// Takes two halves: each takes as many samples as the other half's pilot asks for.
Stop stop_by_other_half(Rng& random, int pilot) {
    Halves<RunningVariance> half{draw_lamps(random, pilot / 2), draw_lamps(random, pilot / 2)};
    const Halves<Real> spread{std::sqrt(variance(half.first)), std::sqrt(variance(half.second))};
    const Halves<int> counts =
        crossed_counts(spread, spread, wanted_error, {pilot / 2, most_samples});
    while (half.first.count < counts.first) add(half.first, lamp_or_dark(random));
    while (half.second.count < counts.second) add(half.second, lamp_or_dark(random));
    return {static_cast<double>(twin_mean({half.first.mean, half.second.mean})),
            static_cast<double>(half.first.count + half.second.count)};
}

// The results of stopping rules in many runs: the mean of all runs, and how often each result
// occurred.
void study_stopping(study::Report& report) {
    using Rule = Stop (*)(Rng&, int pilot);
    constexpr std::array<std::pair<const char*, Rule>, 3> rules{
        {{"stops by its own error", stop_by_own_error},
         {"its pilot decides", stop_by_own_pilot},
         {"the other half's pilot decides", stop_by_other_half}}};
    constexpr int runs = 10'000;
    for (const auto& [name, rule] : rules) {
        for (int pilot = 8; pilot <= 128; pilot *= 2) {
            double sum = 0, squares = 0, samples = 0;
            std::array<int, 24> bins{};
            Rng random{11, 5};
            for (int run = 0; run < runs; ++run) {
                const Stop stop = rule(random, pilot);
                sum += stop.mean - lamp_mean;
                squares += std::pow(stop.mean - lamp_mean, 2);
                samples += stop.samples / runs;
                ++bins[std::min(static_cast<std::size_t>(10 * stop.mean), bins.size() - 1)];
            }
            report.add({"Bias", name, static_cast<double>(pilot), "samples in the pilot",
                        sum / runs, "mean error", samples, "samples"});
            report.add({"Stopping error", name, static_cast<double>(pilot), "samples in the pilot",
                        std::sqrt(squares / runs), "RMSE", samples, "samples"});
            if (pilot != 16) continue;
            for (std::size_t i = 0; i < bins.size(); ++i)
                report.add({"Means", name, (static_cast<double>(i) + 0.5) / 10 - lamp_mean,
                            "error of the mean, in bins of 0.1",
                            static_cast<double>(bins[i]) / runs, "share of 10 000 runs", samples,
                            "samples"});
        }
    }
}

// How much noise a denoiser removes, and how much of the picture it loses. Draws a part of the
// picture at full size, because in a small picture nearly every pixel is at an edge.
void study_denoiser(study::Report& report, const std::string& name, const Tile& window) {
    const Stage stage{960, 540, window};
    const Image truth = stage.draw_with(SobolSamples{77, 512});
    const auto features = stage.draw<Features>([&](int x, int y) {
        return features_at(stage.ready, {1, 16}, x, y, Real(0.1));
    });
    const double lost = rmse(denoised(truth, features, {}), truth);
    struct Trial {
        int samples;
        Image before, after;
    };
    std::vector<Trial> trials;
    for (int samples = 1; samples <= 64; samples *= 4) trials.push_back({samples, {}, {}});
    std::vector<study::Work> works;
    for (Trial& trial : trials) {
        works.push_back([&] { trial.before = stage.draw_with(SobolSamples{1, trial.samples}); });
        works.push_back([&] { trial.after = denoised(trial.before, features, {}); });
    }
    const auto ns = study::in_turns_ns(works, {.rounds = 3});
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const auto& [samples, before, after] = trials[i];
        const double drawing = ns[2 * i], denoising = ns[2 * i + 1];
        const auto add_row = [&, x = samples](const char* variant, double error, double cost) {
            report.add({"Denoiser, " + name, variant, static_cast<double>(x), "samples per pixel",
                        error, "RMSE in a pixel", 1e-6 * cost, "time / ms"});
        };
        add_row("as drawn", rmse(before, truth), drawing);
        add_row("denoised", rmse(after, truth), drawing + denoising);
        add_row("the converged picture denoised", lost, denoising);
    }
}

void run_study(study::Report& report) {
    study_samples(report);
    study_stopping(report);
    study_denoiser(report, "matte floor", {448, 372, 512, 420});
    study_denoiser(report, "metal and glass", {540, 390, 604, 438});
}

}  // namespace
}  // namespace samples

void (*const app::program_study)(study::Report&) = samples::run_study;
