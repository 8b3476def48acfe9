#pragma once
// How the ranks share out a picture: tiles from a counter (13.2), which travel to rank 0 while
// other tiles are drawn (13.3) and are kept on its disk (13.4); or slices of the rows, gathered at
// the end (13.1).

#include <app/errors.hpp>
#include <app/run.hpp>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <rt/draw_by_tiles.hpp>
#include <rt/gather_rows.hpp>
#include <rt/slice_rows.hpp>
#include <rt/tile_counter.hpp>
#include <rt/tile_messages.hpp>
#include <string>
#include <thread>
#include <vector>

#include "collector.hpp"
#include "job.hpp"
#include "talk.hpp"
#include "tile_drawer.hpp"

namespace cluster {

using namespace rt;

inline TileGrid grid_of(const Job& job) {
    return {job.settings.width, job.settings.height, job.tile_side};
}

// Copies the pixels of a tile to its place in the picture.
inline void put_tile(const Tile& tile, const std::vector<Color>& pixels, Image& image) {
    std::size_t next = 0;
    for_each_pixel(tile, [&](int x, int y) { image.at(x, y) = pixels.at(next++); });
}

// What rank 0 knows when the picture is finished.
struct Shared {
    std::uint64_t rays = 0;  // of all ranks
    std::vector<int> lost;   // the ranks that no longer answer
};

// Draws this rank's share of the tiles. Each thread of `drawer` has a tile of its own. Meanwhile
// the calling thread, the only one that may call MPI, takes the next tiles from the counter, and
// sends or collects the finished ones. When no new tile is left, it takes tiles that are out. On
// all ranks except rank 0, `collector` is null, and what is returned is empty. If a rank is lost,
// no collective call of MPI can succeed afterward.
inline Shared share_tiles(const Job& job, TileDrawer& drawer, Collector* collector) {
    talk();
    const TileGrid grid = grid_of(job);
    auto next = std::make_unique<TileCounter>(MPI_COMM_WORLD);
    TileSender sender{MPI_COMM_WORLD};
    Helper self;
    Helpers others;
    Shared shared;
    bool is_new_one_left = true;
    const auto next_tile = [&]() -> std::optional<int> {
        if (is_new_one_left) {
            if (const std::optional<int> index = take_tile(*next, job.count))
                return tile_number(job, *index);
            is_new_one_left = false;
        }
        const std::optional<int> tile = collector ? collector->outstanding() : self.outstanding();
        if (tile && drawer.is_drawing(*tile)) return {};
        return tile;
    };
    for (bool is_over = false; !is_over;) try {
            while (drawer.has_free_thread()) {
                const std::optional<int> tile = next_tile();
                if (!tile) break;
                drawer.hand_out(*tile, tile_at(grid, *tile));
            }
            if (std::optional<DrawnTile> drawn = drawer.take_back(time_away)) {
                shared.rays += drawn->rays;
                if (collector)
                    collector->add(drawn->number, 0, drawn->pixels);
                else
                    sender.send(drawn->number, std::move(drawn->pixels));
            }
            if (collector) {
                collector->receive();
                others.answer([&] { return collector->outstanding(); });
                is_over = collector->is_over();
            } else {
                is_over = self.is_dismissed();
            }
        } catch (const std::exception& error) {
            // All ranks must destroy the counter together, so one rank cannot stop alone.
            std::fprintf(stderr, "13_cluster: rank %d: %s\n", rank_of(MPI_COMM_WORLD),
                         error.what());
            MPI_Abort(MPI_COMM_WORLD, app::could_not);
        }
    if (!collector) {
        sender.finish();
        self.say_farewell(shared.rays);
        return {};
    }
    shared.lost = others.dismiss(std::chrono::seconds{5}, [&] { collector->receive(); });
    shared.rays += others.rays();
    if (!shared.lost.empty()) next.release();  // its destructor would wait for them
    return shared;
}

// The rows of a picture, as an image can take them over without a copy.
struct GatheredRows {
    int columns = 0, rows = 0;
    std::vector<Color> pixels;

    int width() const { return columns; }
    int height() const { return rows; }
    Color* begin() { return pixels.data(); }
};

// Draws this rank's slice of the rows with this many threads. Returns the picture on rank 0, and
// no picture on the other ranks.
inline app::Picture share_slices(const Job& job, const PixelColor& color, int threads) {
    const int width = job.settings.width, height = job.settings.height;
    const Rows rows = slice_rows(height, rank_count(MPI_COMM_WORLD), rank_of(MPI_COMM_WORLD));
    std::vector<Color> mine(static_cast<std::size_t>(width) *
                            static_cast<std::size_t>(rows.end - rows.begin));
    std::atomic<std::uint64_t> rays = 0;
    render_tiles({width, rows.end - rows.begin, 16}, threads,
                 [&](const Tile& tile, int /*worker*/) {
                     std::uint64_t tile_rays = 0;
                     for_each_pixel(tile, [&](int x, int y) {
                         mine[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(x)] = color(x, rows.begin + y, tile_rays);
                     });
                     rays += tile_rays;
                 });
    std::vector<Color> all = gather_rows(mine, width, height, MPI_COMM_WORLD);
    const std::uint64_t own_rays = rays;
    std::uint64_t all_rays = 0;
    MPI_Reduce(&own_rays, &all_rays, 1, MPI_UINT64_T, MPI_SUM, 0, MPI_COMM_WORLD);
    if (all.empty()) return {};
    return {Image{GatheredRows{width, height, std::move(all)}}, all_rays};
}

// Draws the picture without other ranks.
inline app::Picture draw_alone(const Job& job, const PixelColor& color, int threads,
                               app::Progress& progress) {
    return draw_by_tiles(
        grid_of(job), threads, progress,
        [draw = pixel_by_pixel(color)](const Tile& tile, int /*worker*/, Image& image,
                                       std::uint64_t& rays) { return draw(tile, image, rays); });
}

// Calls the exercises 13.1 to 13.3 once, on this rank alone, so that an unwritten exercise is
// reported before the other ranks begin.
inline void rehearse() {
    TileCounter next{MPI_COMM_SELF};
    TileSender sender{MPI_COMM_SELF};
    sender.send(take_tile(next, 1).value_or(0), {Color{}});
    std::optional<ArrivingTile> arriving;
    while (!arriving) arriving = receive_tile(MPI_COMM_SELF);
    MPI_Wait(&arriving->request, MPI_STATUS_IGNORE);
    sender.finish();
    gather_rows(std::vector<Color>(1), 1, 1, MPI_COMM_SELF);
}

}  // namespace cluster
