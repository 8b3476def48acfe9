#pragma once
// The tools with which this chapter's checkpoints watch threads. Nothing here waits forever.
// Right code ends every wait at once; otherwise the wait ends after a while, so wrong code fails
// instead of hanging.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <rt/tile.hpp>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace checkpoint {

// Two seconds, in short pieces: if the machine pauses, only one of them is lost.
inline constexpr std::chrono::milliseconds piece{10};
inline constexpr int pieces = 200;

// Here threads wait for each other.
class MeetingPlace {
  public:
    // Waits until this many threads have come. Returns false if they did not come in time; after
    // that, nobody waits here anymore.
    bool wait_for(int people) {
        std::unique_lock lock{mutex_};
        ++here_;
        changed_.notify_all();
        for (int i = 0; i < pieces && here_ < people && !gave_up_; ++i)
            changed_.wait_for(lock, piece);
        if (here_ < people) gave_up_ = true;
        changed_.notify_all();
        return here_ >= people;
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int here_ = 0;
    bool gave_up_ = false;
};

// Workers wait here for each other, and sign with their numbers and threads.
class Roll {
  public:
    explicit Roll(int workers) : workers_{workers} {}

    // Every worker calls this once.
    void sign(int worker) {
        {
            const std::lock_guard lock{mutex_};
            numbers_.insert(worker);
            threads_.insert(std::this_thread::get_id());
        }
        met_ += place_.wait_for(workers_);
    }

    // What went wrong; empty if nothing did. Each worker must come once, each in a thread of its
    // own, all at the same time.
    std::string complaint() const {
        std::multiset<int> expected;
        for (int worker = 0; worker < workers_; ++worker) expected.insert(worker);
        const std::string all = std::to_string(workers_);
        if (met_ != workers_)
            return std::to_string(met_) + " of " + all + " workers met all the others";
        if (numbers_ != expected) return "the numbers of the workers are not 0 ... " + all + " - 1";
        if (threads_.count(std::this_thread::get_id()))
            return "the calling thread is itself one of the workers";
        if (static_cast<int>(threads_.size()) != workers_)
            return std::to_string(threads_.size()) + " threads for " + all + " workers";
        return {};
    }

  private:
    int workers_;
    std::atomic<int> met_ = 0;
    std::multiset<int> numbers_;
    std::set<std::thread::id> threads_;
    std::mutex mutex_;
    MeetingPlace place_;
};

inline std::string text(const rt::Tile& tile) {
    return "columns " + std::to_string(tile.left) + " to " + std::to_string(tile.right) +
           " of rows " + std::to_string(tile.top) + " to " + std::to_string(tile.bottom);
}

// Counts how often each pixel of a picture is rendered, and what else a Strategy may get wrong.
class PixelCounts {
  public:
    PixelCounts(const rt::TileGrid& grid, int workers)
        : grid_{grid},
          counts_(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height)),
          busy_(static_cast<std::size_t>(workers)) {}

    // A TileWork, which may be called from several threads.
    void operator()(const rt::Tile& tile, int worker) {
        {
            const std::lock_guard lock{mutex_};
            ++tiles;
            const bool is_worker = 0 <= worker && worker < static_cast<int>(busy_.size());
            if (!is_worker) ++unknown_workers;
            if (is_worker && busy_[static_cast<std::size_t>(worker)]++) ++overlapping_workers;
            const bool inside = 0 <= tile.left && tile.right <= grid_.width && 0 <= tile.top &&
                                tile.bottom <= grid_.height;
            if (!inside && !outside++) first_outside_ = tile;
            if (tile.left >= tile.right || tile.top >= tile.bottom) ++empty;
            if (inside)
                for (int y = tile.top; y < tile.bottom; ++y)
                    for (int x = tile.left; x < tile.right; ++x) ++counts_[index(x, y)];
        }
        std::this_thread::yield();  // others may come in between
        const std::lock_guard lock{mutex_};
        if (0 <= worker && worker < static_cast<int>(busy_.size()))
            --busy_[static_cast<std::size_t>(worker)];
    }

    // The first tile that is outside the picture or the first pixel that was not rendered once, in
    // words; empty if there is none.
    std::string complaint() const {
        if (outside > 0) return "a tile has " + text(first_outside_);
        for (int y = 0; y < grid_.height; ++y)
            for (int x = 0; x < grid_.width; ++x)
                if (const int count = counts_[index(x, y)]; count != 1)
                    return "pixel (" + std::to_string(x) + ", " + std::to_string(y) +
                           ") is rendered " + std::to_string(count) + " times";
        return {};
    }

    int tiles = 0, unknown_workers = 0, overlapping_workers = 0, outside = 0, empty = 0;

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.width) +
               static_cast<std::size_t>(x);
    }

    rt::TileGrid grid_;
    rt::Tile first_outside_{};
    std::vector<int> counts_;
    std::vector<int> busy_;
    std::mutex mutex_;
};

// Checks all of that, after the work.
#define CHECK_RENDERED_ONCE(counts)                                                             \
    {                                                                                           \
        {                                                                                       \
            INFO(                                                                               \
                "Hint: a tile is {left, top, right, bottom}, and ends where the picture ends. " \
                "Each tile has one worker");                                                    \
            CHECK((counts).complaint() == "");                                                  \
        }                                                                                       \
        INFO(                                                                                   \
            "Hint: 'outside' counts tiles that reach over the picture's edge, 'empty' "         \
            "those without a pixel, 'unknown_workers' numbers that are not 0 ... "              \
            "workers - 1, 'overlapping_workers' calls that ran at the same time under "         \
            "one number");                                                                      \
        CHECK((counts).outside == 0);                                                           \
        CHECK((counts).empty == 0);                                                             \
        CHECK((counts).unknown_workers == 0);                                                   \
        CHECK((counts).overlapping_workers == 0);                                               \
    }

}  // namespace checkpoint
