#pragma once
// How the ranks share out a picture: tiles from a counter (13.2), which travel to rank 0 while
// other tiles are drawn (13.3) and are kept on its disk (13.4); or slices of the rows, gathered at
// the end (13.1).

#include <app/errors.hpp>
#include <app/run.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <future>
#include <optional>
#include <rt/gather_rows.hpp>
#include <rt/saved_tiles.hpp>
#include <rt/slice_rows.hpp>
#include <rt/tile_counter.hpp>
#include <rt/tile_messages.hpp>
#include <string>
#include <thread>

#include "job.hpp"
#include "tile_drawer.hpp"

namespace cluster {

using namespace rt;
using std::chrono::milliseconds;

inline TileGrid grid_of(const Job& job) {
    return {job.settings.width, job.settings.height, job.tile_side};
}

// Collects the tiles of the picture at rank 0.
class Collector {
  public:
    // Finished tiles are kept in `folder`; if its name is empty, none are kept.
    Collector(const Job& job, std::filesystem::path folder, app::Progress& progress)
        : grid_{grid_of(job)},
          image_{Canvas<Color>{grid_.width, grid_.height}},
          drawn_by_(static_cast<std::size_t>(tile_count(grid_)), -1),
          folder_{std::move(folder)},
          progress_{progress} {
        progress_.start(tile_count(grid_));
    }

    // Adds a tile from an earlier run.
    void add_old(int tile) { put(tile, load_tile(folder_, tile)); }

    // Adds a tile that `rank` has drawn. If the tile cannot be written to the folder, error() tells
    // why. Nothing is thrown, because the ranks must end together.
    void add(int tile, int rank, const std::vector<Color>& pixels) {
        put(tile, pixels);
        drawn_by_[static_cast<std::size_t>(tile)] = rank;
        if (folder_.empty() || !error_.empty()) return;
        try {
            save_tile(folder_, tile, pixels);
        } catch (const std::runtime_error& error) {
            error_ = error.what();
        }
    }

    // Receives all tiles that have arrived.
    void receive() {
        while (const std::optional<ArrivedTile> arrived = receive_tile(MPI_COMM_WORLD)) {
            add(arrived->tile, arrived->from, arrived->pixels);
            ++received_;
        }
    }

    std::int64_t received() const { return received_; }
    const std::string& error() const { return error_; }
    Image& image() { return image_; }
    const std::vector<int>& drawn_by() const { return drawn_by_; }

  private:
    void put(int tile, const std::vector<Color>& pixels) {
        std::size_t next = 0;
        for_each_pixel(tile_at(grid_, tile),
                       [&](int x, int y) { image_.at(x, y) = pixels.at(next++); });
        progress_.step();
    }

    TileGrid grid_;
    Image image_;
    std::vector<int> drawn_by_;  // the rank that drew each tile; -1: none in this run
    std::filesystem::path folder_;
    app::Progress& progress_;
    std::int64_t received_ = 0;
    std::string error_;
};

// Calls work() in a thread of its own. Until work() returns, calls serve() once a millisecond in
// the calling thread: only this thread may call MPI, and messages make progress only during calls
// of MPI.
template <class Work, class Serve>
void work_and_serve(const Work& work, const Serve& serve) {
    std::future<void> working = std::async(std::launch::async, work);
    while (working.wait_for(milliseconds{1}) != std::future_status::ready) serve();
    working.get();
}

// Draws this rank's share of the tiles. On all ranks except rank 0, `collector` is null. On rank 0,
// returns the number of rays of all ranks.
inline std::uint64_t share_tiles(const Job& job, TileDrawer& drawer, Collector* collector) {
    const TileGrid grid = grid_of(job);
    const int count = static_cast<int>(job.tiles.size());
    TileCounter next{MPI_COMM_WORLD};
    TileSender sender{MPI_COMM_WORLD};
    std::uint64_t rays = 0;
    std::int64_t sent = 0;
    const auto serve = [&] {
        if (collector) collector->receive();
    };
    while (const std::optional<int> index = take_tile(next, count)) try {
            const int tile = job.tiles[static_cast<std::size_t>(*index)];
            std::vector<Color> pixels;
            work_and_serve([&] { pixels = drawer.draw(tile_at(grid, tile), rays); }, serve);
            if (collector) {
                collector->add(tile, 0, pixels);
                // The other ranks then find no more tiles.
                if (!collector->error().empty()) next.fetch_add(count);
            } else {
                sender.send(tile, std::move(pixels));
                ++sent;
            }
        } catch (const std::exception& error) {
            // All ranks must destroy the counter together, so one rank cannot stop alone.
            std::fprintf(stderr, "13_cluster: rank %d: %s\n", rank_of(MPI_COMM_WORLD),
                         error.what());
            MPI_Abort(MPI_COMM_WORLD, app::could_not);
        }
    // Rank 0 goes on receiving until all ranks have said how many tiles they sent, and all of these
    // tiles have arrived.
    std::int64_t mine[2] = {sent, static_cast<std::int64_t>(rays)}, all[2] = {0, 0};
    MPI_Request sums{};
    MPI_Ireduce(mine, all, 2, MPI_INT64_T, MPI_SUM, 0, MPI_COMM_WORLD, &sums);
    sender.finish();
    for (int are_here = 0; collector && (!are_here || collector->received() < all[0]);) {
        collector->receive();
        if (!are_here) MPI_Test(&sums, &are_here, MPI_STATUS_IGNORE);
        std::this_thread::sleep_for(milliseconds{1});
    }
    if (!collector) MPI_Wait(&sums, MPI_STATUS_IGNORE);
    return static_cast<std::uint64_t>(all[1]);
}

// Draws this rank's slice of the rows. On rank 0, `image` gets the whole picture; on the other
// ranks, it is null. On rank 0, returns the number of rays of all ranks.
inline std::uint64_t share_slices(const Job& job, TileDrawer& drawer, Image* image) {
    const auto& settings = job.settings;
    const Rows rows =
        slice_rows(settings.height, rank_count(MPI_COMM_WORLD), rank_of(MPI_COMM_WORLD));
    std::uint64_t rays = 0, all_rays = 0;
    const std::vector<Color> all =
        gather_rows(drawer.draw({0, rows.begin, settings.width, rows.end}, rays), settings.width,
                    settings.height, MPI_COMM_WORLD);
    if (image) std::copy(all.begin(), all.end(), &image->at(0, 0));
    MPI_Reduce(&rays, &all_rays, 1, MPI_UINT64_T, MPI_SUM, 0, MPI_COMM_WORLD);
    return all_rays;
}

// Calls the exercises 13.1 to 13.3 once, on this rank alone, so that an unwritten exercise is
// reported before the other ranks begin.
inline void rehearse() {
    TileCounter next{MPI_COMM_SELF};
    TileSender sender{MPI_COMM_SELF};
    sender.send(take_tile(next, 1).value_or(0), {Color{}});
    while (!receive_tile(MPI_COMM_SELF)) {
    }
    sender.finish();
    gather_rows(std::vector<Color>(1), 1, 1, MPI_COMM_SELF);
}

}  // namespace cluster
