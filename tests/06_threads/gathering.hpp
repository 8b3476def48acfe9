#pragma once
// What the checkpoints of this chapter watch threads with. Nothing here waits for ever: what right
// code brings about at once is given up after a while, so that wrong code fails instead of hanging.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <rt/tile.hpp>
#include <string>
#include <vector>

namespace checkpoint {

inline constexpr std::chrono::seconds patience{2};

// A place where threads wait for each other.
class MeetingPlace {
  public:
    // Waits until this many have come. False when they did not come in time; after that nobody
    // waits here any more.
    bool wait_for(int people) {
        std::unique_lock lock{mutex_};
        ++here_;
        changed_.notify_all();
        if (!changed_.wait_for(lock, patience, [&] { return here_ >= people || gave_up_; }))
            gave_up_ = true;
        changed_.notify_all();
        return here_ >= people;
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int here_ = 0;
    bool gave_up_ = false;
};

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
            if (!inside) ++outside;
            if (tile.left >= tile.right || tile.top >= tile.bottom) ++empty;
            if (inside)
                for (int y = tile.top; y < tile.bottom; ++y)
                    for (int x = tile.left; x < tile.right; ++x) ++counts_[index(x, y)];
        }
        const std::lock_guard lock{mutex_};
        if (0 <= worker && worker < static_cast<int>(busy_.size()))
            --busy_[static_cast<std::size_t>(worker)];
    }

    // The first pixel that was not rendered once, in words; empty if there is none.
    std::string complaint() const {
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
    std::vector<int> counts_;
    std::vector<int> busy_;
    std::mutex mutex_;
};

// Checks all of that, after the work.
#define CHECK_RENDERED_ONCE(counts)                                                     \
    {                                                                                   \
        INFO(                                                                           \
            "Hint: 'outside' counts tiles that reach over the picture's edge, 'empty' " \
            "those without a pixel, 'unknown_workers' numbers that are not 0 ... "      \
            "workers - 1, 'overlapping_workers' calls that ran at the same time under " \
            "one number");                                                              \
        CHECK((counts).complaint() == "");                                              \
        CHECK((counts).outside == 0);                                                   \
        CHECK((counts).empty == 0);                                                     \
        CHECK((counts).unknown_workers == 0);                                           \
        CHECK((counts).overlapping_workers == 0);                                       \
    }

// How a piece of work ended that ran in a process of its own, so that the checkpoint survives it.
enum class Ending { returned, threw, program_ended };

// work() runs in a copy of this process. It must do everything that it needs threads for itself.
template <class Work>
Ending ending_of(Work work) {
    const pid_t child = fork();
    if (child == 0) {
        std::set_terminate([] { _exit(3); });  // what an exception in a thread leads to
        alarm(20);
        try {
            work();
        } catch (...) {
            _exit(2);
        }
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (!WIFEXITED(status)) return Ending::program_ended;
    return WEXITSTATUS(status) == 0   ? Ending::returned
           : WEXITSTATUS(status) == 2 ? Ending::threw
                                      : Ending::program_ended;
}

// Leaves this process only so much more address space: enough for a few threads. False where that
// cannot be done: under sanitizers, and where there is no /proc.
inline bool leave_room_for_few_threads() {
    long pages = 0;
    if (std::FILE* const file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%ld", &pages) != 1) pages = 0;
        std::fclose(file);
    }
    const long long used = static_cast<long long>(pages) * sysconf(_SC_PAGESIZE);
    if (used == 0 || used > 1LL << 40) return false;
    const auto limit = static_cast<rlim_t>(used + (64LL << 20));
    const rlimit both{limit, limit};
    return setrlimit(RLIMIT_AS, &both) == 0;
}

inline std::string text(Ending ending) {
    switch (ending) {
        case Ending::returned:
            return "a normal return";
        case Ending::threw:
            return "an exception that reaches the caller";
        default:
            return "the end of the whole program (std::terminate)";
    }
}

}  // namespace checkpoint
