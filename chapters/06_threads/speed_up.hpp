#pragma once
// How much faster several workers are than one, by this machine's clock.

#include <cstdio>
#include <rt/counted.hpp>
#include <rt/strategies.hpp>
#include <string>
#include <study/median.hpp>
#include <study/timing.hpp>
#include <thread>
#include <vector>

#include "scene.hpp"

namespace threads {

// Renders a small picture of the scene once, with one strategy.
struct SmallRender {
    const Scene& scene;
    TileGrid grid{240, 135, 8};
    int samples = 4;

    void operator()(Strategy strategy, int workers) const {
        const SceneShader shader{scene, make_camera(scene_view(), grid.width, grid.height), samples,
                                 12, 1};
        render_image(strategy, grid, workers,
                     [&](int x, int y, int) { return shader(x, y).color; });
    }
};

struct SpeedUp {
    std::string strategy;
    int workers = 1;
    double ns = 0;     // median
    double times = 1;  // how many times as fast as one worker in the same round, median
};

// 1, 2, 3, ... up to `most`; beyond 8 only powers of two, and `most` itself.
inline std::vector<int> worker_counts(int most) {
    std::vector<int> counts;
    for (int n = 1; n < most; n += n < 8 ? 1 : n) counts.push_back(n);
    counts.push_back(most);
    return counts;
}

// Renders with each strategy and with 1 to `most` workers.
inline std::vector<SpeedUp> speed_ups(const Scene& scene, int most) {
    const SmallRender render{scene};
    std::vector<SpeedUp> rows;
    std::vector<study::Work> works;
    for (const NamedStrategy& strategy : strategies())
        for (const int workers : worker_counts(most)) {
            rows.push_back({strategy.name, workers});
            works.push_back([&render, way = strategy.render, workers] { render(way, workers); });
        }
    const auto rounds = study::rounds_ns(works, {.rounds = 5, .clock = study::Clock::wall});
    std::size_t alone = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].workers == 1) alone = i;
        std::vector<double> times;
        for (std::size_t round = 0; round < rounds[i].size(); ++round)
            times.push_back(rounds[alone][round] / rounds[i][round]);
        rows[i].times = study::median(times);
        rows[i].ns = study::median(rounds[i]);
    }
    return rows;
}

inline std::string table(const std::vector<SpeedUp>& rows) {
    const unsigned cores = std::thread::hardware_concurrency();
    std::string text = "Measured on " + counted(cores, "core") +
                       ", a small picture of the scene, median of five:\n"
                       "strategy          workers      time  speed-up\n";
    for (const SpeedUp& row : rows) {
        char line[96];
        std::snprintf(line, sizeof line, "%-16s %8d %6.1f ms %8.2fx\n", row.strategy.c_str(),
                      row.workers, row.ns * 1e-6, row.times);
        text += line;
    }
    return text;
}

}  // namespace threads
