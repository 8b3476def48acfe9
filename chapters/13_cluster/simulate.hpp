#pragma once
// Simulates how long a picture takes on many machines, tile by tile, from the time that a core
// takes for each tile and from the costs of messages.

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>
#include <queue>
#include <rt/rng.hpp>
#include <utility>
#include <vector>

namespace cluster {

// Costs in seconds. Rank 0 serves one machine at a time.
struct Costs {
    double take = 0;     // what a step of the counter takes of rank 0's time
    double message = 0;  // what a message takes of rank 0's time, whatever its size
    double pixel = 0;    // what each pixel of a message adds to that
    double delay = 0;  // from a question to the counter's answer, if rank 0 has nothing else to do
};

// The machines that draw. All are equally fast, except for the last one, which takes `slow` times
// as long for everything that it draws.
struct Machines {
    int count = 1, cores = 1;
    double slow = 1;
    bool draw_again = false;  // whether tiles that are out are given out again at the end
};

// What a core does with a tile: it asks for it, then draws it.
struct ScheduledTile {
    int machine;
    double asks, begins, ends;  // seconds
    bool is_copy;               // of a tile that another machine draws
};

struct Simulated {
    double seconds = 0;     // until the last tile is at rank 0
    double efficiency = 0;  // the time spent drawing, but not copies, divided by cores and seconds
    double last_wait = 0;   // the share of the cores' time spent waiting for the last tile
    std::vector<ScheduledTile> schedule;
};

// The model assumes that all machines begin at the same time; that each core draws a tile of its
// own; that one thread of each machine talks to rank 0, sends a finished tile and asks for the next
// one, and waits for the answer; and that the network carries all messages at the same time, so
// that they queue only at rank 0.
class Simulation {
  public:
    // `tiles` holds the seconds that a core takes to draw each tile, in the order in which the
    // tiles are taken. `pixels` is the number of pixels in each tile.
    Simulation(const std::vector<double>& tiles, double pixels, const Machines& machines,
               const Costs& costs)
        : tiles_{tiles},
          machines_{machines},
          costs_{costs},
          message_{costs.message + pixels * costs.pixel},
          talks_until_(static_cast<std::size_t>(machines.count)) {
        for (int core = 0; core < machines.cores; ++core)
            for (int machine = 0; machine < machines.count; ++machine)
                cores_.push({0, machine, false});
    }

    Simulated run() {
        double drawing = 0, waiting = 0;
        for (const double seconds : tiles_) {
            draw(send(), seconds, false);
            ends_.push_back(schedule_.back().ends);
        }
        auto idle = cores_;
        const double last = finish();
        for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
            drawing += std::min(schedule_[tile].ends, last) - schedule_[tile].begins;
        for (; !idle.empty(); idle.pop()) waiting += std::max(0.0, last - idle.top().free_at);
        const double all = machines_.count * machines_.cores * rank_0_free_;
        return {rank_0_free_, drawing / all, waiting / all, std::move(schedule_)};
    }

  private:
    struct Core {
        double free_at;  // seconds
        int machine;
        bool has_drawn;  // and so has a tile to send
        bool operator>(const Core& other) const { return free_at > other.free_at; }
    };

    double& talks_until(const Core& core) {
        return talks_until_[static_cast<std::size_t>(core.machine)];
    }

    // The core that is free first sends its tile. If its machine talks for another core, it waits.
    Core send() {
        Core core = cores_.top();
        cores_.pop();
        while (talks_until(core) > core.free_at) {
            cores_.push({talks_until(core), core.machine, core.has_drawn});
            core = cores_.top();
            cores_.pop();
        }
        rank_0_free_ = std::max(core.free_at, rank_0_free_);
        if (core.has_drawn) rank_0_free_ += message_;
        return core;
    }

    // Then it asks for the next tile, and draws it.
    void draw(const Core& core, double seconds, bool is_copy) {
        rank_0_free_ += costs_.take;
        const double begins = talks_until(core) = rank_0_free_ + costs_.delay;
        const double slow = core.machine == machines_.count - 1 ? machines_.slow : 1;
        schedule_.push_back({core.machine, core.free_at, begins, begins + slow * seconds, is_copy});
        cores_.push({schedule_.back().ends, core.machine, true});
    }

    // All tiles are given out. Returns when the last one is drawn.
    double finish() {
        for (std::size_t tile = 0; tile < tiles_.size() && machines_.draw_again; ++tile)
            out_.push_back(tile);
        const auto latest = [&] {
            return ends_.empty() ? 0 : *std::max_element(ends_.begin(), ends_.end());
        };
        double last = latest();
        while (!cores_.empty() && cores_.top().free_at <= last) {
            const Core core = send();
            if (const std::optional<std::size_t> tile = outstanding(core)) {
                draw(core, tiles_[*tile], true);
                ends_[*tile] = std::min(ends_[*tile], schedule_.back().ends);
                last = latest();
            }
        }
        return last;
    }

    // The next tile that is out, if it is drawn by another machine.
    std::optional<std::size_t> outstanding(const Core& core) {
        std::erase_if(out_, [&](std::size_t tile) { return ends_[tile] <= core.free_at; });
        for (std::size_t tries = out_.size(); tries > 0; --tries) {
            const std::size_t tile = out_.front();
            out_.pop_front();
            out_.push_back(tile);
            if (schedule_[tile].machine != core.machine) return tile;
        }
        return {};
    }

    const std::vector<double>& tiles_;
    Machines machines_;
    Costs costs_;
    double message_, rank_0_free_ = 0;
    std::priority_queue<Core, std::vector<Core>, std::greater<>> cores_;
    std::vector<double> talks_until_;  // by machine
    std::vector<ScheduledTile> schedule_;
    std::vector<double> ends_;     // of each tile: when its first copy is drawn
    std::deque<std::size_t> out_;  // tiles that may be given out again
};

inline Simulated simulate(const std::vector<double>& tiles, double pixels, const Machines& machines,
                          const Costs& costs) {
    return Simulation{tiles, pixels, machines, costs}.run();
}

// The efficiency with work stealing, without a counter at rank 0. Each of n cores begins with every
// n-th tile. A core that has no tiles left asks a core chosen at random, and gets half of the tiles
// that this core has left. If it gets none, it waits before it asks again, each time twice as long.
//
// In addition, the model assumes that a question takes `steal` seconds, and that a core answers one
// question after the other. All cores write into one file, so rank 0 receives nothing.
inline double simulate_stealing(const std::vector<double>& tiles, int cores, double steal) {
    const auto count = static_cast<std::size_t>(cores);
    struct Core {
        std::size_t next = 0, left = 0;  // its next tile, and how many it has
        double answers_from = 0;         // when it can answer the next question
        double patience = 0;             // seconds until it asks again
    };
    std::vector<Core> all;
    using Free = std::pair<double, std::size_t>;  // when, and which core
    std::priority_queue<Free, std::vector<Free>, std::greater<>> free_at;
    for (std::size_t i = 0; i < count; ++i) {
        all.push_back({i, (tiles.size() + count - 1 - i) / count, 0, steal});
        free_at.push({0, i});
    }
    rt::Rng random{13, 8};
    double drawing = 0, last = 0;
    for (std::size_t taken = 0; taken < tiles.size();) {
        const auto [now, index] = free_at.top();
        free_at.pop();
        Core& self = all[index];
        double free_again = 0;
        if (self.left > 0) {
            free_again = now + tiles[self.next];
            drawing += tiles[self.next];
            last = std::max(last, free_again);
            self.next += count;
            --self.left;
            self.patience = steal;
            ++taken;
        } else {
            Core& other = all[random() % count];
            free_again = other.answers_from = std::max(now, other.answers_from) + steal;
            self.left = (other.left + 1) / 2;
            other.left -= self.left;
            self.next = other.next + other.left * count;
            if (self.left == 0) {
                free_again += self.patience;
                self.patience *= 2;
            }
        }
        free_at.push({free_again, index});
    }
    return drawing / (cores * last);
}

}  // namespace cluster
