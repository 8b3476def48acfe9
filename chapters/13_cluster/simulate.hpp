#pragma once
// Simulates how long a picture takes on many machines, tile by tile, from the time that one machine
// takes for each tile and from the costs of messages.

#include <algorithm>
#include <functional>
#include <queue>
#include <rt/rng.hpp>
#include <utility>
#include <vector>

namespace cluster {

// Costs in seconds. The counter and the collector, both at rank 0, each serve one machine at a
// time.
struct Costs {
    double take = 0;     // a step of the counter
    double message = 0;  // a message at rank 0, whatever its size
    double pixel = 0;    // what each pixel of a message adds to that
};

struct Simulated {
    double seconds = 0;     // until the last tile is at rank 0
    double efficiency = 0;  // the time spent drawing, divided by machines times seconds
    double last_wait = 0;   // the share of the machines' time spent waiting for the last tile
};

// `tiles` holds the seconds that a machine takes to draw each tile, in the order in which the tiles
// are taken. `pixels` is the number of pixels in each tile.
//
// The model assumes that all machines are equally fast and begin at the same time; that a machine
// waits until the counter gives it a tile, but not until a finished tile has been sent; and that
// the network carries all messages at the same time, so that messages queue only at rank 0.
inline Simulated simulate(const std::vector<double>& tiles, double pixels, int machines,
                          const Costs& costs) {
    std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
    for (int machine = 0; machine < machines; ++machine) free_at.push(0);
    double counter_free = 0, drawing = 0, waiting = 0;
    std::vector<double> ends;
    for (const double seconds : tiles) {
        const double asks = free_at.top();
        free_at.pop();
        counter_free = std::max(asks, counter_free) + costs.take;
        ends.push_back(counter_free + seconds);
        free_at.push(ends.back());
        drawing += seconds;
    }
    std::sort(ends.begin(), ends.end());
    double collector_free = 0;
    for (const double end : ends)
        collector_free = std::max(end, collector_free) + costs.message + pixels * costs.pixel;
    for (; !free_at.empty(); free_at.pop()) waiting += ends.back() - free_at.top();
    return {collector_free, drawing / (machines * collector_free),
            waiting / (machines * collector_free)};
}

// The efficiency with work stealing, without a counter at rank 0. Each of n machines begins with
// every n-th tile. A machine that has no tiles left asks a machine chosen at random, and gets half
// of the tiles that this machine has left. If it gets none, it waits before it asks again, each
// time twice as long.
//
// In addition, the model assumes that a question takes `steal` seconds, and that a machine answers
// one question after the other. All machines write into one file, so rank 0 receives nothing.
inline double simulate_stealing(const std::vector<double>& tiles, int machines, double steal) {
    const auto count = static_cast<std::size_t>(machines);
    struct Machine {
        std::size_t next = 0, left = 0;  // its next tile, and how many it has
        double answers_from = 0;         // when it can answer the next question
        double patience = 0;             // seconds until it asks again
    };
    std::vector<Machine> all;
    using Free = std::pair<double, std::size_t>;  // when, and which machine
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
        Machine& self = all[index];
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
            Machine& other = all[random() % count];
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
    return drawing / (machines * last);
}

}  // namespace cluster
