#pragma once
// How long a picture takes on many machines, from the costs of one: an event for each tile.

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace cluster {

// In seconds. The counter and the collector, both at rank 0, serve one machine after the other.
struct Costs {
    double take = 0;     // a step of the counter
    double message = 0;  // a message at rank 0, whatever its size
    double pixel = 0;    // of a message at rank 0, for each pixel
};

struct Simulated {
    double seconds = 0;     // until the last tile is at rank 0
    double efficiency = 0;  // the time of drawing, over machines times seconds
    double last_wait = 0;   // the share of the machines' time that is spent waiting for the last
};

// `tiles` are the seconds that a machine draws at each tile, in the order in which they are taken;
// each has this many pixels.
//
// Assumed: all machines are equally fast and begin at once; a machine waits for its next tile, but
// not until a tile has been sent; the network carries all messages at a time, and only rank 0 is
// busy with them.
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

}  // namespace cluster
