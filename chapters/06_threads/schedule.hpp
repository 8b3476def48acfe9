#pragma once
// Which worker renders which part of the picture, and when.

#include <algorithm>
#include <chrono>
#include <mutex>
#include <rt/for_each_pixel.hpp>
#include <rt/slice_rows.hpp>
#include <rt/strategies.hpp>
#include <vector>

namespace threads {

using namespace rt;

struct Span {
    Tile tile;
    int worker = 0;
    double begin = 0, end = 0;
};

struct Schedule {
    int workers = 1;
    std::vector<Span> spans;

    // The time at which the last worker is done.
    double end() const {
        double last = 0;
        for (const Span& span : spans) last = std::max(last, span.end);
        return last;
    }
    // The time at which this worker is done; from then on it waits.
    double end_of(int worker) const {
        double last = 0;
        for (const Span& span : spans)
            if (span.worker == worker) last = std::max(last, span.end);
        return last;
    }
    // The share of all workers' time in which they wait because nothing is left to do.
    double waiting() const {
        double sum = 0;
        for (int worker = 0; worker < workers; ++worker) sum += end() - end_of(worker);
        return end() > 0 ? sum / (end() * workers) : 0;
    }
};

// How many rays each pixel of a picture took, stored so that the sum over a tile is quick to
// compute: the entry at (x, y) is the sum over all pixels to the left of x and above y.
class RayCounts {
  public:
    RayCounts(int width, int height, const std::vector<std::uint32_t>& rays)
        : width_{width},
          sums_(static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1)) {
        std::size_t i = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                at(x + 1, y + 1) = at(x, y + 1) + at(x + 1, y) - at(x, y) + rays[i++];
    }
    double in(const Tile& t) const {
        return static_cast<double>(at(t.right, t.bottom) - at(t.left, t.bottom) -
                                   at(t.right, t.top) + at(t.left, t.top));
    }

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 1) +
               static_cast<std::size_t>(x);
    }
    std::uint64_t& at(int x, int y) { return sums_[index(x, y)]; }
    std::uint64_t at(int x, int y) const { return sums_[index(x, y)]; }

    int width_;
    std::vector<std::uint64_t> sums_;
};

// The schedule if the clock ticks once per ray: what would happen if every ray took the same time,
// and each worker had a core of its own. It is the same on every machine.
inline Schedule slices_by_rays(const RayCounts& rays, const TileGrid& grid, int workers) {
    Schedule schedule{workers, {}};
    for (int worker = 0; worker < workers; ++worker) {
        const Rows rows = slice_rows(grid.height, workers, worker);
        const Tile tile{0, rows.begin, grid.width, rows.end};
        if (rows.begin < rows.end) schedule.spans.push_back({tile, worker, 0, rays.in(tile)});
    }
    return schedule;
}

inline Schedule tiles_by_rays(const RayCounts& rays, const TileGrid& grid, int workers) {
    Schedule schedule{workers, {}};
    std::vector<double> free_at(static_cast<std::size_t>(workers));
    for (int i = 0; i < tile_count(grid); ++i) {
        const Tile tile = tile_at(grid, i);
        const auto first_free = std::min_element(free_at.begin(), free_at.end());
        const double begin = *first_free;
        *first_free += rays.in(tile);
        schedule.spans.push_back(
            {tile, static_cast<int>(first_free - free_at.begin()), begin, *first_free});
    }
    return schedule;
}

// The schedule by this machine's clock: what really happens, in seconds.
template <class Shade>
Schedule by_seconds(Strategy strategy, const TileGrid& grid, int workers, const Shade& shade) {
    using Clock = std::chrono::steady_clock;
    Schedule schedule{workers, {}};
    std::mutex mutex;
    const auto start = Clock::now();
    const auto now = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    strategy(grid, workers, [&](const Tile& tile, int worker) {
        const double begin = now();
        for_each_pixel(tile, [&](int x, int y) { shade(x, y); });
        const double end = now();
        const std::lock_guard lock{mutex};
        schedule.spans.push_back({tile, worker, begin, end});
    });
    return schedule;
}

}  // namespace threads
