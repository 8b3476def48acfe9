// Measures what a step of the shared counter and a tile's message cost, and whether the simulation
// in simulate.hpp agrees with real ranks:
//
//     mpirun -n 4 build/bin/cluster_measure
//
// Tiles are not drawn: a thread sleeps as long as a tile would take. So a run with more threads
// than cores tells as much as a run with a core for each. With OMPI_MCA_btl=self,tcp and
// OMPI_MCA_osc=pt2pt, messages go over TCP, as between machines.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <rt/counted.hpp>
#include <rt/rng.hpp>
#include <thread>

#include "group.hpp"
#include "share.hpp"
#include "simulate.hpp"

namespace {

using namespace rt;
using cluster::Costs;

const MPI_Comm all = MPI_COMM_WORLD;
constexpr int threads = 4;  // of each rank

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

double median(std::vector<double> times) {
    std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
    return times[times.size() / 2];
}

// The seconds from a question of rank 1 to the counter's answer, while rank 0 visits MPI as often
// as it does while its threads draw.
double delay() {
    constexpr int steps = 1000;
    TileCounter counter{all};
    std::vector<double> times;
    MPI_Barrier(all);
    for (int i = 0; i < steps && rank_of(all) == 1; ++i) {
        const double begin = MPI_Wtime();
        counter.fetch_add(1);
        times.push_back(MPI_Wtime() - begin);
        std::this_thread::sleep_for(std::chrono::microseconds{137});
    }
    MPI_Request all_are_here{};
    MPI_Ibarrier(all, &all_are_here);
    for (int are_here = 0; !are_here;) {
        if (rank_of(all) == 0) std::this_thread::sleep_for(cluster::time_away);
        MPI_Test(&all_are_here, &are_here, MPI_STATUS_IGNORE);
    }
    double found = times.empty() ? 0 : median(times);
    if (rank_count(all) > 1) MPI_Bcast(&found, 1, MPI_DOUBLE, 1, all);
    return found;
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
        std::optional<ArrivingTile> arriving = receive_tile(all);
        if (!arriving) continue;
        MPI_Wait(&arriving->request, MPI_STATUS_IGNORE);
        times.push_back(MPI_Wtime() - begin);
        --left;
    }
    MPI_Barrier(all);
    if (times.empty()) return 0;
    std::printf("a tile of %d x %d at rank 0: median %.1f us, the fastest %.1f, the slowest %.1f\n",
                side, side, 1e6 * median(times),
                1e6 * *std::min_element(times.begin(), times.end()),
                1e6 * *std::max_element(times.begin(), times.end()));
    return median(times);
}

// The seconds that real ranks take for these tiles, if their threads sleep instead of drawing.
double real_seconds(const std::vector<double>& tiles, int side) {
    cluster::Job job;
    job.settings.width = side * static_cast<int>(tiles.size());
    job.settings.height = job.tile_side = side;
    job.count = static_cast<int>(tiles.size());
    const PixelColor color = [&](int x, int y, std::uint64_t&) {
        if (x % side == 0 && y == 0)
            std::this_thread::sleep_for(
                std::chrono::duration<double>{tiles[static_cast<std::size_t>(x / side)]});
        return Color{};
    };
    app::Progress progress{false};
    cluster::Collector collector{job.count, [](int, const std::vector<Color>&) {}, nullptr,
                                 progress};
    cluster::TileDrawer drawer{color, threads};
    MPI_Barrier(all);
    const double begin = MPI_Wtime();
    cluster::share_tiles(job, drawer, rank_of(all) == 0 ? &collector : nullptr);
    MPI_Barrier(all);
    return MPI_Wtime() - begin;
}

}  // namespace

int main(int argc, char** argv) {
    const cluster::Membership membership{argc, argv};
    const bool tells = rank_of(all) == 0;
    const double take = take_cost(), wait = delay();
    if (tells)
        std::printf("a step of the counter: %.2f us; from question to answer: median %.1f us\n",
                    1e6 * take, 1e6 * wait);
    const double small = message_cost(16), large = message_cost(64);
    const double pixel = (large - small) / (64 * 64 - 16 * 16);
    const Costs costs{take, small - 256 * pixel, pixel, wait};

    // Tiles of 1 to 60 ms, most of them short, as in a picture.
    Rng random{13, 7};
    std::vector<double> tiles;
    for (int i = 0; i < 1000; ++i) {
        const double u = static_cast<double>(random.uniform());
        tiles.push_back(0.001 + 0.059 * u * u * u);
    }
    const double real = real_seconds(tiles, 64);
    const auto simulated = cluster::simulate(
        tiles, 64 * 64, {.count = rank_count(all), .cores = threads, .draw_again = true}, costs);
    if (tells)
        std::printf("%s of %d threads: %.3f s, simulated %.3f s\n",
                    counted(rank_count(all), "rank").c_str(), threads, real, simulated.seconds);
}
