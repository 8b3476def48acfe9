// Compares ways to share out the samples of a pixel: which of them keep the picture's bytes, and
// what they cost. Then simulates up to 10,000 machines that share out tiles.

#include <app/run.hpp>
#include <array>
#include <cmath>
#include <cstdint>
#include <rt/rng.hpp>
#include <rt/slice_rows.hpp>
#include <string>
#include <study/double_double.hpp>
#include <study/report.hpp>
#include <thread>
#include <vector>

#include "final_scene.hpp"
#include "simulate.hpp"
#include "tile_drawer.hpp"

namespace cluster {
namespace {

using namespace rt;

// ---- The samples of a pixel on several ranks -------------------------------------------------

constexpr int pixels = 4000, samples = 256;
constexpr std::array rank_counts{1, 2, 4, 8, 16, 64};

// Light of very different brightness, as paths bring it.
std::vector<double> some_light() {
    rt::Rng random{13, 5};
    std::vector<double> light;
    for (int i = 0; i < samples; ++i) {
        const double u = static_cast<double>(random.uniform());
        light.push_back(static_cast<double>(static_cast<Real>(0.3 * u + (u > 0.98 ? 40 * u : 0))));
    }
    return light;
}

// The mean of a pixel whose samples are shared out in slices: each rank adds up its slice, and rank
// 0 adds up the sums of all ranks.
Real by_partial_sums(const std::vector<double>& light, int ranks) {
    double sum = 0;
    for (int rank = 0; rank < ranks; ++rank) {
        double part = 0;
        for (int i = samples * rank / ranks; i < samples * (rank + 1) / ranks; ++i)
            part += light[static_cast<std::size_t>(i)];
        sum += part;
    }
    return static_cast<Real>(sum / samples);
}

// The same in whole multiples of 2^-40: any order gives the same sum.
Real by_fixed_point(const std::vector<double>& light, int ranks) {
    std::int64_t sum = 0;
    for (int rank = 0; rank < ranks; ++rank)
        for (int i = samples * rank / ranks; i < samples * (rank + 1) / ranks; ++i)
            sum += std::llrint(std::ldexp(light[static_cast<std::size_t>(i)], 40));
    return static_cast<Real>(std::ldexp(static_cast<double>(sum), -40) / samples);
}

// All samples travel to rank 0, which adds them in their order.
Real in_order(const std::vector<double>& light, int) {
    return by_partial_sums(light, 1);
}

using Way = Real (*)(const std::vector<double>&, int);

void study_split(study::Report& report) {
    std::vector<std::vector<double>> all;
    rt::Rng random{13, 6};
    const std::vector<double> light = some_light();
    for (int i = 0; i < pixels; ++i) {
        std::vector<double> shuffled = light;
        for (double& value : shuffled) value *= static_cast<double>(Real(0.5) + random.uniform());
        all.push_back(std::move(shuffled));
    }
    const std::array<std::pair<const char*, Way>, 3> ways{{{"sums of parts", by_partial_sums},
                                                           {"fixed point", by_fixed_point},
                                                           {"all in order", in_order}}};
    for (const auto& [name, way] : ways) {
        double largest = 0;
        for (const int ranks : rank_counts) {
            int differ = 0;
            for (const auto& light_of_pixel : all) {
                const Real alone = way(light_of_pixel, 1), shared = way(light_of_pixel, ranks);
                differ += shared != alone;
                study::DoubleDouble exact{};
                for (const double value : light_of_pixel)
                    exact = exact + study::DoubleDouble{value};
                const double off = std::abs(static_cast<double>(shared) - exact.high / samples);
                largest = std::max(largest, off);
            }
            report.add({"split samples", name, static_cast<double>(ranks), "ranks",
                        100.0 * differ / pixels, "pixels that change / %"});
        }
        report.add({"error in a pixel", name, 0, "", largest, "largest error in a pixel"});
        report.add(
            {"adding", name, samples, "samples", 0, "", 0, "time per sample / ns"},
            [way = way, pixel = all.front()] { study::keep(way(pixel, 8)); }, samples);
    }
}

// ---- How many machines tiles keep busy -------------------------------------------------------

// The rays of each block of 8 x 8 pixels of the final scene, at 960 x 540 with one sample per
// pixel.
constexpr int columns = 120, rows = 68, block = 8;

std::vector<double> rays_of_blocks() {
    rt::MeshedDescription scene{effects::final_scene(), {}};
    scene.settings = {960, 540, 1, scene.settings.depth, 1};
    const PixelColor color = colors_of(scene);
    std::vector<double> all(std::size_t{columns} * rows);
    render_tiles({960, 540, block},
                 std::max(1, static_cast<int>(std::thread::hardware_concurrency())),
                 [&](const Tile& tile, int /*worker*/) {
                     std::uint64_t rays = 0;
                     for_each_pixel(tile, [&](int x, int y) { color(x, y, rays); });
                     all[static_cast<std::size_t>(tile.top / block * columns + tile.left / block)] =
                         static_cast<double>(rays);
                 });
    return all;
}

// The seconds that a core takes for each tile of a larger picture: the same scene, eight times as
// wide and as high, with 1024 samples per pixel. A block then has 64 x 64 pixels. Smaller tiles
// have equal shares of a block's rays; larger tiles consist of several blocks. A core follows 1.2
// million rays per second, the speed that the program prints.
std::vector<double> tile_seconds(const std::vector<double>& rays, int side) {
    const double scale = 64.0 * 1024 / 1.2e6;
    std::vector<double> tiles;
    if (side <= 64) {
        const int parts = 64 / side;
        for (int y = 0; y < rows * parts; ++y)
            for (int x = 0; x < columns * parts; ++x)
                tiles.push_back(scale / (parts * parts) *
                                rays[static_cast<std::size_t>(y / parts * columns + x / parts)]);
        return tiles;
    }
    const int blocks = side / 64;
    for (int y = 0; y < rows; y += blocks)
        for (int x = 0; x < columns; x += blocks) {
            double sum = 0;
            for (int v = y; v < std::min(rows, y + blocks); ++v)
                for (int u = x; u < std::min(columns, x + blocks); ++u)
                    sum += rays[static_cast<std::size_t>(v * columns + u)];
            tiles.push_back(scale * sum);
        }
    return tiles;
}

constexpr int cores = 16;  // of a machine

// What measure/measure.cpp printed for 4 ranks on one machine, through its memory, and over TCP.
// Between machines, a message takes longer: here with a latency of 20 us and a bandwidth of 1 GB/s,
// for colors of 24 bytes.
constexpr Costs within_a_machine{0.02e-6, 7e-6, 3.2e-9, 0.1e-6},
    over_a_network{20e-6, 20e-6, 24e-9, 350e-6};
constexpr Costs without_a_collector{over_a_network.take, 0, 0, over_a_network.delay};

// The efficiency of n groups of machines: each group has its own counter and collector, and draws
// every n-th tile of the picture.
double efficiency_in_groups(const std::vector<double>& rays, int side, int machines, int groups) {
    const auto tiles = tile_seconds(rays, side);
    double drawing = 0, longest = 0;
    for (int group = 0; group < groups; ++group) {
        std::vector<double> own;
        for (auto i = static_cast<std::size_t>(group); i < tiles.size();
             i += static_cast<std::size_t>(groups))
            own.push_back(tiles[i]);
        for (const double seconds : own) drawing += seconds;
        longest = std::max(
            longest,
            simulate(own, side * side, {machines / groups, cores}, over_a_network).seconds);
    }
    return drawing / (machines * cores * longest);
}

// The efficiency with a slice of the rows for each machine (13.1), if nothing else costs time: all
// machines wait for the slowest.
double efficiency_of_slices(const std::vector<double>& rays, int machines) {
    double all = 0, slowest = 0;
    for (int machine = 0; machine < machines; ++machine) {
        const rt::Rows slice = rt::slice_rows(rows, machines, machine);
        double own = 0;
        for (int i = slice.begin * columns; i < slice.end * columns; ++i)
            own += rays[static_cast<std::size_t>(i)];
        all += own;
        slowest = std::max(slowest, own);
    }
    return all / (machines * slowest);
}

void study_machines(study::Report& report) {
    const std::vector<double> rays = rays_of_blocks();
    const auto simulated = [&](int side, const Machines& machines, const Costs& costs) {
        return simulate(tile_seconds(rays, side), side * side, machines, costs);
    };
    const auto add = [&](const char* name, const std::string& variant, int machines,
                         double efficiency) {
        report.add({name, variant, static_cast<double>(machines), "machines", 100 * efficiency,
                    "efficiency / %"});
    };
    const auto tiles_of = [](int side) { return "tiles of " + std::to_string(side); };
    for (const int machines : {1, 2, 4, 8})
        add("sharing", "slices", machines, efficiency_of_slices(rays, machines));
    for (const int machines : {1, 2, 4, 8})
        add("sharing", "tiles of 32", machines,
            simulated(32, {machines, cores}, over_a_network).efficiency);
    for (const auto& [name, costs] : {std::pair{"machines", over_a_network},
                                      std::pair{"messages through memory", within_a_machine}})
        for (const int side : {8, 16, 32, 64})
            for (const int machines : {1, 10, 100, 1000, 10'000})
                add(name, tiles_of(side), machines,
                    simulated(side, {machines, cores}, costs).efficiency);
    for (const int machines : {1, 10, 100, 1000, 10'000})
        add("no rank 0 for all", "tiles of 8, no collector", machines,
            simulated(8, {machines, cores}, without_a_collector).efficiency);
    for (const int machines : {100, 1000, 10'000})
        add("no rank 0 for all", "tiles of 8, in 100 groups", machines,
            efficiency_in_groups(rays, 8, machines, 100));
    for (const int machines : {100, 1000, 10'000})
        add("no rank 0 for all", "tiles of 8, work stealing", machines,
            simulate_stealing(tile_seconds(rays, 8), machines * cores, 2 * over_a_network.message));
    for (const int side : {8, 16, 32, 64})
        report.add({"last tile", "waiting", static_cast<double>(side), "pixels of a tile's side",
                    100 * simulated(side, {100, cores}, over_a_network).last_wait,
                    "time of 100 machines that wait for the last tile / %"});
    for (const bool draw_again : {false, true})
        for (const double slow : {1, 2, 4, 10, 100})
            report.add({"a slow machine", draw_again ? "out again" : "out once", slow,
                        "times as slow as the other nine",
                        simulated(32, {10, cores, slow, draw_again}, over_a_network).seconds,
                        "seconds of 10 machines"});
}

void run_study(study::Report& report) {
    study_split(report);
    study_machines(report);
    report.time_in_turns();
}

}  // namespace
}  // namespace cluster

void (*const app::program_study)(study::Report&) = cluster::run_study;
