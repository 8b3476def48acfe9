#pragma once
// How much faster several workers are than one, by this machine's clock.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <rt/strategies.hpp>
#include <string>
#include <thread>
#include <vector>

#include "scene.hpp"

namespace threads {

inline double median(std::vector<double> numbers) {
    std::nth_element(numbers.begin(), numbers.begin() + static_cast<long>(numbers.size() / 2),
                     numbers.end());
    return numbers[numbers.size() / 2];
}

template <class Work>
double seconds_of(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The scene, small: rendered once by one strategy.
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

struct Measured {
    std::string strategy;
    int workers = 1;
    double seconds = 0;   // median
    double speed_up = 1;  // median of the ratios with one worker right before
};

// 1, 2, 3, ... most; from 8 on every second power of two alone, and most itself.
inline std::vector<int> worker_counts(int most) {
    std::vector<int> counts;
    for (int n = 1; n < most; n += n < 8 ? 1 : n) counts.push_back(n);
    counts.push_back(most);
    return counts;
}

// Renders by each strategy with 1 to `most` workers, five times in turn, so that whatever else the
// machine does disturbs all alike.
inline std::vector<Measured> measure(const Scene& scene, int most, int rounds = 5) {
    const SmallRender render{scene};
    std::vector<Measured> rows;
    std::vector<std::vector<double>> seconds, speed_ups;
    for (int round = 0; round < rounds; ++round) {
        std::size_t i = 0;
        for (const NamedStrategy& strategy : strategies()) {
            double alone = 0;
            for (const int workers : worker_counts(most)) {
                const double time = seconds_of([&] { render(strategy.render, workers); });
                if (workers == 1) alone = time;
                if (round == 0) {
                    rows.push_back({strategy.name, workers, 0, 0});
                    seconds.emplace_back();
                    speed_ups.emplace_back();
                }
                seconds[i].push_back(time);
                speed_ups[i++].push_back(alone / time);
            }
        }
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].seconds = median(seconds[i]);
        rows[i].speed_up = median(speed_ups[i]);
    }
    return rows;
}

inline std::string table(const std::vector<Measured>& rows) {
    const unsigned cores = std::thread::hardware_concurrency();
    std::string text = "Measured on " + std::to_string(cores) + (cores == 1 ? " core" : " cores") +
                       ", the scene in small, median of five:\n"
                       "strategy          workers      time  speed-up\n";
    for (const Measured& row : rows) {
        char line[96];
        std::snprintf(line, sizeof line, "%-16s %8d %6.1f ms %8.2fx\n", row.strategy.c_str(),
                      row.workers, row.seconds * 1000, row.speed_up);
        text += line;
    }
    return text;
}

}  // namespace threads
