// Measures what a step of the shared counter and a tile's message cost, and whether the simulation
// in simulate.hpp agrees with real ranks:
//
//     mpirun -n 4 build/bin/cluster_measure
//
// Tiles are not drawn: a rank sleeps as long as a tile would take. So a run with more ranks than
// cores tells as much as a run with one rank per core.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <rt/counted.hpp>
#include <rt/gather_rows.hpp>
#include <rt/render_tiles.hpp>
#include <rt/rng.hpp>
#include <rt/tile_counter.hpp>
#include <rt/tile_messages.hpp>
#include <thread>

#include "group.hpp"
#include "simulate.hpp"

namespace {

using namespace rt;
using cluster::Costs;

const MPI_Comm all = MPI_COMM_WORLD;

void sleep(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>{seconds});
}

// The seconds that rank 0's counter takes for a step, while all ranks count at once.
double take_cost() {
    constexpr int steps = 2000;
    TileCounter counter{all};
    MPI_Barrier(all);
    const double begin = MPI_Wtime();
    for (int i = 0; i < steps; ++i) counter.fetch_add(1);
    MPI_Barrier(all);
    return (MPI_Wtime() - begin) / (steps * rank_count(all));
}

// The seconds that rank 0 takes to receive a tile with this side, once the tile has arrived.
double message_cost(int side) {
    constexpr int count = 60;
    std::vector<double> times;
    TileSender sender{all};
    MPI_Barrier(all);
    if (rank_of(all) > 0) {
        for (int i = 0; i < count; ++i)
            sender.send(i, std::vector<Color>(static_cast<std::size_t>(side * side)));
        sender.finish();
    }
    for (int left = count * (rank_count(all) - 1); rank_of(all) == 0 && left > 0;) {
        const double begin = MPI_Wtime();
        if (!receive_tile(all)) continue;
        times.push_back(MPI_Wtime() - begin);
        --left;
    }
    MPI_Barrier(all);
    if (times.empty()) return 0;
    std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
    std::printf("a tile of %d x %d at rank 0: median %.1f us, the fastest %.1f, the slowest %.1f\n",
                side, side, 1e6 * times[times.size() / 2],
                1e6 * *std::min_element(times.begin(), times.end()),
                1e6 * *std::max_element(times.begin(), times.end()));
    return times[times.size() / 2];
}

// The seconds that real ranks take for these tiles if they sleep instead of drawing.
double real_seconds(const std::vector<double>& tiles, int side) {
    TileCounter next{all};
    TileSender sender{all};
    const int count = static_cast<int>(tiles.size());
    int mine = 0;
    MPI_Barrier(all);
    const double begin = MPI_Wtime();
    int received = 0;
    while (const auto tile = take_tile(next, count)) {
        const double end = MPI_Wtime() + tiles[static_cast<std::size_t>(*tile)];
        while (MPI_Wtime() < end) {
            if (rank_of(all) == 0) received += receive_tile(all).has_value();
            sleep(std::min(0.001, std::max(0.0, end - MPI_Wtime())));
        }
        if (rank_of(all) > 0)
            sender.send(*tile, std::vector<Color>(static_cast<std::size_t>(side * side)));
        else
            ++mine;
    }
    sender.finish();
    while (rank_of(all) == 0 && received + mine < count) received += receive_tile(all).has_value();
    MPI_Barrier(all);
    return MPI_Wtime() - begin;
}

}  // namespace

int main(int argc, char** argv) {
    const cluster::Membership membership{argc, argv};
    const bool tells = rank_of(all) == 0;
    const double take = take_cost();
    if (tells) std::printf("a step of the counter: %.2f us\n", 1e6 * take);
    const double small = message_cost(16), large = message_cost(64);
    const double pixel = (large - small) / (64 * 64 - 16 * 16);
    const Costs costs{take, small - 256 * pixel, pixel};

    // Tiles of 1 to 60 ms, most of them short, as in a picture.
    Rng random{13, 7};
    std::vector<double> tiles;
    for (int i = 0; i < 300; ++i) {
        const double u = static_cast<double>(random.uniform());
        tiles.push_back(0.001 + 0.059 * u * u * u);
    }
    const double real = real_seconds(tiles, 64);
    const auto simulated = cluster::simulate(tiles, 64 * 64, rank_count(all), costs);
    if (tells)
        std::printf("%s: %.3f s, simulated %.3f s; efficiency %.1f %%, simulated %.1f %%\n",
                    counted(rank_count(all), "rank").c_str(), real, simulated.seconds,
                    100 * simulated.efficiency * simulated.seconds / real,
                    100 * simulated.efficiency);
}
