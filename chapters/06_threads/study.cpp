// What it costs to use several threads: workers that wait, tiles that are too small or too large,
// memory that two workers write to in turn, a counter that all share.

#include <app/run.hpp>
#include <atomic>
#include <cstddef>
#include <deque>
#include <mutex>
#include <string_view>
#include <study/pixel_error.hpp>
#include <study/report.hpp>

#include "schedule.hpp"
#include "speed_up.hpp"

namespace threads {
namespace {

int core_count() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// The name of an error. Where threads race, the error is a matter of chance, and the name says so:
// ./course study then does not count it as a difference.
std::string error_of(const std::string& name, bool races) {
    return name + (races ? " by chance / %" : " / %");
}

struct Trial {
    std::string variant;
    int x = 1, workers = 1;
    study::Work work;
};

// Times the trials and a plain loop in turns, and adds a row for each trial: its time, and the
// percentage of the cores' time that it loses, compared with the plain loop.
void add_trials(study::Report& report, const char* study, const char* x_name,
                const SmallRender& render, const std::vector<Trial>& trials) {
    const SceneShader shader{render.scene,
                             make_camera(scene_view(), render.grid.width, render.grid.height),
                             render.samples, 12, 1};
    std::vector<study::Work> works{[&] {
        study::keep(make_image(render.grid.width, render.grid.height,
                               [&](int x, int y) { return shader(x, y).color; }));
    }};
    for (const Trial& trial : trials) works.push_back(trial.work);
    const auto rounds = study::rounds_ns(works, {.rounds = 7, .clock = study::Clock::wall});
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const std::vector<double>&alone = rounds[0], &ns = rounds[i + 1];
        std::vector<double> lost;
        for (std::size_t round = 0; round < ns.size(); ++round)
            lost.push_back(
                100 * (1 - alone[round] / (ns[round] * std::min(trials[i].workers, core_count()))));
        report.add({.study = study,
                    .variant = trials[i].variant,
                    .x = static_cast<double>(trials[i].x),
                    .x_name = x_name,
                    .error = study::median(lost),
                    .error_name = "cores' time lost / %",
                    .cost = 1e-6 * study::median(ns),
                    .cost_name = "time / ms"});
    }
}

void study_strategies(study::Report& report, const Scene& scene) {
    const SmallRender render{scene, {160, 90, 8}, 2};
    std::vector<Trial> trials;
    for (const NamedStrategy& strategy : strategies())
        for (const int workers : {1, 2, 4, 8})
            trials.push_back(
                {strategy.name, workers, workers,
                 [&render, named = strategy.render, workers] { render(named, workers); }});
    add_trials(report, "Strategies", "workers", render, trials);
}

// One generator for all workers, which use it one at a time.
struct LockedRng {
    Rng random{1, 1};
    std::mutex mutex;

    Real uniform() {
        const std::lock_guard lock{mutex};
        return random.uniform();
    }
};

// Ways to give each sample its random numbers: for each way, the time it takes, and in how many
// pixels the picture differs from the one that a single worker draws.
void study_streams(study::Report& report, const Scene& scene) {
    const TileGrid grid{160, 90, 8};
    const SceneShader shader{scene, make_camera(scene_view(), grid.width, grid.height), 2, 12, 1};
    const auto average = [&](int x, int y, auto& random) {
        Color sum;
        for (int i = 0; i < shader.samples; ++i) sum += shader.sample(scene.world, x, y, i, random);
        return sum / static_cast<Real>(shader.samples);
    };
    std::vector<study::Row> in_a_pixel;
    const auto add = [&](const char* variant, bool races, auto draw) {
        constexpr std::array all_workers{1, 2, 4};
        Image alone;
        std::array<std::vector<double>, all_workers.size()> differ, off;
        std::vector<study::Work> works;
        for (std::size_t i = 0; i < all_workers.size(); ++i)
            works.push_back([&, i] {
                const Image image = draw(all_workers[i]);
                if (i == 0) alone = image;
                int count = 0;
                for (std::size_t k = 0; k < image.pixels().size(); ++k)
                    count += image.pixels()[k] != alone.pixels()[k];
                differ[i].push_back(100.0 * count / static_cast<double>(image.pixels().size()));
                off[i].push_back(study::root_mean_square_error(image.pixels(), alone.pixels()));
            });
        const auto times = study::in_turns_ns(works, {.clock = study::Clock::wall});
        for (std::size_t i = 0; i < all_workers.size(); ++i)
            report.add({.study = "Random streams",
                        .variant = variant,
                        .x = static_cast<double>(all_workers[i]),
                        .x_name = "workers",
                        .error = study::median(differ[i]),
                        .error_name = error_of("pixels that differ", races),
                        .cost = 1e-6 * times[i],
                        .cost_name = "time / ms"});
        in_a_pixel.push_back(study::pixel_error(std::string{variant} + ", 2 workers", 2, "workers",
                                                study::median(off[1])));
        if (races) in_a_pixel.back().error_name += " by chance";
    };
    add("one for all, locked", true, [&](int workers) {
        LockedRng random;
        return render_image(render_tiles, grid, workers,
                            [&](int x, int y, int) { return average(x, y, random); });
    });
    add("one a worker", true, [&](int workers) {
        struct alignas(64) OwnRng {
            Rng random;
        };
        std::vector<OwnRng> own;
        for (int i = 0; i < workers; ++i) own.push_back({pixel_rng(1, i, 0)});
        return render_image(render_tiles, grid, workers, [&](int x, int y, int worker) {
            return average(x, y, own[static_cast<std::size_t>(worker)].random);
        });
    });
    add("one a pixel", false, [&](int workers) {
        return render_image(render_tiles, grid, workers, [&](int x, int y, int) {
            Rng random = pixel_rng(1, x, y);
            return average(x, y, random);
        });
    });
    add("one a sample", false, [&](int workers) {
        return render_image(render_tiles, grid, workers, [&](int x, int y, int) {
            return average_samples(1, x, y, shader.samples, [&](int number, Rng& random) {
                return shader.sample(scene.world, x, y, number, random);
            });
        });
    });
    for (const study::Row& row : in_a_pixel) report.add(row);
}

void study_tile_size(study::Report& report, const Scene& scene) {
    const SmallRender render{scene, {160, 90, 8}, 2};
    const int workers = core_count();
    std::vector<Trial> trials;
    for (int size = 1; size <= 128; size *= 2)
        trials.push_back({"tiles", size, workers, [&, size] {
                              SmallRender sized = render;
                              sized.grid.tile_size = size;
                              sized(render_tiles, workers);
                          }});
    add_trials(report, "Tile size", "pixels along a tile", render, trials);
}

// How long workers wait if each has a core of its own and the clock ticks once per ray: the same on
// every machine.
void study_waiting(study::Report& report, const Scene& scene) {
    const TileGrid grid{240, 135, 8};
    const SceneShader shader{scene, make_camera(scene_view(), grid.width, grid.height), 4, 12, 1};
    std::vector<std::uint32_t> counts;
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x)
            counts.push_back(static_cast<std::uint32_t>(shader(x, y).rays));
    const RayCounts rays{grid.width, grid.height, counts};
    const auto add = [&](const std::string& variant, const Schedule& schedule) {
        report.add({.study = "Waiting by rays",
                    .variant = variant,
                    .x = static_cast<double>(schedule.workers),
                    .x_name = "workers",
                    .error = 100 * schedule.waiting(),
                    .error_name = "workers' time waited / %",
                    .cost = schedule.end() / 1000,
                    .cost_name = "time / thousand rays"});
    };
    for (int workers = 1; workers <= 64; workers *= 2) {
        add("slices", slices_by_rays(rays, grid, workers));
        for (const int size : {4, 16, 64})
            add("tiles of " + std::to_string(size),
                tiles_by_rays(rays, {grid.width, grid.height, size}, workers));
    }
}

// Two workers count, each in a number of its own; the two numbers are a few bytes apart. Processors
// move memory in lines, most of them of 64 bytes, often in pairs of lines; only one core at a time
// can write to a line.
void study_false_sharing(study::Report& report) {
    constexpr int count = 30'000'000;
    using Counter = std::atomic<std::uint64_t>;
    alignas(256) static Counter memory[256];
    const auto count_up = [](int workers, std::size_t distance) {
        run_workers(workers, [&](int worker) {
            Counter& mine = memory[static_cast<std::size_t>(worker) * distance];
            // Read, add, write: no atomic step is needed, because nobody else writes here.
            for (int i = 0; i < count; ++i)
                mine.store(mine.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
        });
    };
    std::vector<study::Work> works{[&] { count_up(1, 1); }};
    for (std::size_t distance = 1; distance <= 32; distance *= 2)
        works.push_back([&, distance] { count_up(2, distance); });
    const auto times = study::in_turns_ns(works, {.clock = study::Clock::wall});
    for (std::size_t i = 1; i < times.size(); ++i)
        report.add({.study = "False sharing",
                    .variant = "two workers",
                    .x = static_cast<double>(sizeof(Counter) << (i - 1)),
                    .x_name = "bytes apart",
                    .error = times[i] / times[0],
                    .error_name = "time / one worker's",
                    .cost = times[i] / count,
                    .cost_name = "time per step / ns"});
}

// All workers take numbers from one counter.
void study_counter(study::Report& report) {
    constexpr int count = 1'000'000;
    struct Counting {
        const char* variant;
        int workers;
        std::vector<double> lost;  // of each round, in percent
        study::Work work;
    };
    std::deque<Counting> trials;
    const auto add = [&](const char* variant, int workers, auto take) {
        Counting& trial = trials.emplace_back(Counting{variant, workers, {}, {}});
        trial.work = [&trial, take] {
            std::atomic<int> next = 0;
            run_workers(trial.workers, [&](int) {
                for (int i = 0; i < count; ++i) take(next);
            });
            trial.lost.push_back(100 - 100 * static_cast<double>(next) / count / trial.workers);
        };
    };
    std::mutex mutex;
    for (const int workers : {1, 2, 4}) {
        add("read, then write", workers, [](std::atomic<int>& next) {
            next.store(next.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
        });
        add("fetch_add", workers, [](std::atomic<int>& next) { next.fetch_add(1); });
        add("mutex", workers, [&](std::atomic<int>& next) {
            const std::lock_guard lock{mutex};
            next.store(next.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
        });
    }
    std::vector<study::Work> works;
    for (const Counting& trial : trials) works.push_back(trial.work);
    const auto ns = study::in_turns_ns(works, {.rounds = 9, .clock = study::Clock::wall});
    for (std::size_t i = 0; i < trials.size(); ++i)
        report.add(
            {.study = "Counter",
             .variant = trials[i].variant,
             .x = static_cast<double>(trials[i].workers),
             .x_name = "workers",
             .error = study::median(trials[i].lost),
             .error_name = error_of("numbers taken twice",
                                    std::string_view{trials[i].variant} == "read, then write"),
             .cost = ns[i] / count / trials[i].workers,
             .cost_name = "time per number / ns"});
}

void run_study(study::Report& report) {
    const Scene scene = make_scene();
    study_strategies(report, scene);
    study_waiting(report, scene);
    study_streams(report, scene);
    study_tile_size(report, scene);
    study_false_sharing(report);
    study_counter(report);
}

}  // namespace
}  // namespace threads

void (*const app::program_study)(study::Report&) = threads::run_study;
