#pragma once
// The threads of one rank, each of which draws a tile of its own.

#include <app/run.hpp>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <future>
#include <mutex>
#include <optional>
#include <rt/draw_by_tiles.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/run_workers.hpp>
#include <set>
#include <utility>
#include <vector>

#include "tile_workers.hpp"

namespace cluster {

// The colors of a scene's pixels, path by path, as chapter 08's program computes them. The scene
// must outlive the result.
inline rt::PixelColor colors_of(const rt::MeshedDescription& scene) {
    const auto& [width, height, samples, depth, seed] = scene.settings;
    return full_renderer::make_pixel_renderer(scene, width, height, {samples, depth, seed}).color;
}

struct DrawnTile {
    int number = 0;
    std::vector<rt::Color> pixels;  // row by row
    std::uint64_t rays = 0;
};

// Draws tiles in threads that live as long as it does. It keeps no picture, only the tiles that it
// is working on. All of its functions belong to the thread that made it.
class TileDrawer {
  public:
    // `threads` is 1 or more.
    TileDrawer(rt::PixelColor color, int threads)
        : color_{std::move(color)}, threads_{threads}, running_{std::async(std::launch::async, [&] {
              rt::run_workers(threads_, [&](int) { work(); });
          })} {}

    // Gives up the tiles that are not finished.
    ~TileDrawer() { stop(); }
    TileDrawer(const TileDrawer&) = delete;
    TileDrawer& operator=(const TileDrawer&) = delete;

    bool has_free_thread() const { return handed_out_.size() < static_cast<std::size_t>(threads_); }
    bool is_drawing(int number) const { return handed_out_.count(number) > 0; }

    // Lets a free thread draw this tile.
    void hand_out(int number, const rt::Tile& tile) {
        const std::lock_guard lock{mutex_};
        waiting_.emplace_back(number, tile);
        handed_out_.insert(number);
        more_to_draw_.notify_one();
    }

    // Returns a finished tile, or none if none is finished within `patience`. Throws what a thread
    // has thrown.
    std::optional<DrawnTile> take_back(std::chrono::microseconds patience) {
        std::unique_lock lock{mutex_};
        one_is_drawn_.wait_for(lock, patience, [&] { return is_over_ || !drawn_.empty(); });
        if (is_over_) {
            lock.unlock();
            running_.get();
        }
        if (drawn_.empty()) return {};
        DrawnTile tile = std::move(drawn_.front());
        drawn_.pop_front();
        handed_out_.erase(tile.number);
        return tile;
    }

  private:
    void work() try {
        for (std::unique_lock lock{mutex_};;) {
            more_to_draw_.wait(lock, [&] { return is_over_ || !waiting_.empty(); });
            if (is_over_) return;
            const auto [number, tile] = waiting_.front();
            waiting_.pop_front();
            lock.unlock();
            DrawnTile drawn{number, {}, 0};
            rt::for_each_pixel(tile, [&](int x, int y) {
                if (!is_over_) drawn.pixels.push_back(color_(x, y, drawn.rays));
            });
            lock.lock();
            drawn_.push_back(std::move(drawn));
            one_is_drawn_.notify_one();
        }
    } catch (...) {
        stop();
        throw;
    }

    void stop() {
        const std::lock_guard lock{mutex_};
        is_over_ = true;
        more_to_draw_.notify_all();
        one_is_drawn_.notify_all();
    }

    rt::PixelColor color_;
    int threads_;
    std::set<int> handed_out_;
    std::mutex mutex_;  // of the two queues
    std::condition_variable more_to_draw_, one_is_drawn_;
    std::deque<std::pair<int, rt::Tile>> waiting_;  // for a free thread
    std::deque<DrawnTile> drawn_;
    std::atomic<bool> is_over_ = false;
    std::future<void> running_;
};

}  // namespace cluster
