// The live figure of chapter 13.
#include <array>
#include <rt/renderer.hpp>
#include <rt/slice_rows.hpp>

#include "controls.hpp"
// Chapter 08's last scene, which the ranks draw.
#include "final_scene.cpp"
#include "live.hpp"
#include "placing.cpp"
#include "simulate.hpp"

namespace live {
namespace {

// ---- Which rank draws what, and when ----

constexpr rt::Effects effects{
    .fuzz = true, .glass = true, .lens = true, .lights = true, .instances = true};

// The picture has 960 x 540 pixels with 64 samples each. A block of 16 x 16 is the smallest tile.
constexpr int block = 16, columns = 60, rows = 34;
constexpr double seconds_per_ray = 1 / 1.2e6;

// The seconds that a rank takes for each block, from the rays of one of its pixels.
const std::vector<double>& blocks() {
    static const std::vector<double> found = [] {
        const rt::SceneDescription scene = effects::final_scene();
        const rt::Renderer<live::effects> renderer{scene, columns, rows, {4, 50, 1}};
        std::vector<double> all;
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x) {
                std::uint64_t rays = 0;
                renderer(x, y, rays);
                all.push_back(static_cast<double>(rays) * block * block * 64 / 4 * seconds_per_ray);
            }
        return all;
    }();
    return found;
}

double seconds_of(int left, int top, int right, int bottom) {
    double sum = 0;
    for (int y = top; y < std::min(rows, bottom); ++y)
        for (int x = left; x < std::min(columns, right); ++x)
            sum += blocks()[static_cast<std::size_t>(y * columns + x)];
    return sum;
}

cluster::Simulated schedule_of(const ScheduleControls& c) {
    const int ranks = static_cast<int>(c.ranks);
    const double message = 1e-3 * std::pow(10, c.latency);
    if (c.share == 0) {
        std::vector<double> slices;
        for (int rank = 0; rank < ranks; ++rank) {
            const rt::Rows slice = rt::slice_rows(rows, ranks, rank);
            slices.push_back(seconds_of(0, slice.begin, columns, slice.end));
        }
        slices.back() *= c.slow;
        cluster::Simulated found =
            cluster::simulate(slices, 960 * 540 / c.ranks, {ranks, 1}, {0, message, 24e-9});
        // All ranks begin at once, so the simulation may give each slice to any of them.
        for (std::size_t slice = 0; slice < slices.size(); ++slice)
            found.schedule[slice].machine = static_cast<int>(slice);
        return found;
    }
    const int side = 256 >> static_cast<int>(c.share - 1), step = side / block;
    std::vector<double> tiles;
    for (int y = 0; y < rows; y += step)
        for (int x = 0; x < columns; x += step)
            tiles.push_back(seconds_of(x, y, x + step, y + step));
    return cluster::simulate(tiles, side * side, {ranks, 1, c.slow, true},
                             {message, message, 24e-9});
}

struct ScheduleLayout {
    double left, right, pitch, seconds;  // `seconds` are as long as from left to right

    Point place(double time, int rank) const {
        return {left + (right - left) * time / seconds, 26 + pitch * rank};
    }
};

ScheduleLayout schedule_layout(const ScheduleControls& c, double width) {
    const double shared = seconds_of(0, 0, columns, rows) / c.ranks;
    // The page keeps a place as high, relative to its width.
    const double high = (width < 520 ? 0.61 : 200.0 / 760) * width;
    return {62, width - 4, std::clamp(high / c.ranks, 16.0, 40.0),
            std::max(2 * shared, 1.02 * schedule_of(c).seconds)};
}

}  // namespace

void draw(const ScheduleControls& c, Drawing& out) {
    const int ranks = static_cast<int>(c.ranks);
    const cluster::Simulated found = schedule_of(c);
    const ScheduleLayout layout = schedule_layout(c, out.width);
    const double high = 0.74 * layout.pitch;
    out.height = layout.place(0, ranks).y + 30;
    out.text({layout.right, 10}, "the picture is finished after {.0} s", ink, Align::right,
             found.seconds);
    std::vector<double> ends(static_cast<std::size_t>(ranks));
    Point handle{};
    const double last = found.seconds;
    int tiles = 0;
    for (const auto& [rank, asks, begins, ends_at, is_copy] : found.schedule) {
        // At the end, ranks give up what they still draw.
        const double end = std::min(ends_at, last);
        if (begins >= end) continue;
        const Point from = layout.place(begins, rank), to = layout.place(end, rank);
        const Ink color =
            thin(rank == ranks - 1 && c.slow > 1 ? orange : blue, is_copy ? 0.4 : 1.0);
        tiles += !is_copy;
        const double gap = to.x - from.x > 4 ? 1.5 : 0;
        out.box(from, {std::max(from.x + 0.3, to.x - gap), to.y + high}, color);
        if (rank == ranks - 1 && handle.x == 0) handle = {to.x, to.y + high / 2};
        ends[static_cast<std::size_t>(rank)] = end;
    }
    for (int rank = 0; rank < ranks; ++rank) {
        const Point from = layout.place(ends[static_cast<std::size_t>(rank)], rank);
        const Point to = layout.place(last, rank) + Point{0, high};
        out.text({0, from.y + high / 2}, "rank {}", ink, Align::left, rank);
        for (double x = from.x + 5; x < to.x; x += 6)
            out.line({x - 3, to.y}, {x, from.y}, {thin(muted, 0.7), 1.2});
    }
    const double x = layout.place(last, 0).x;
    out.line({x, 20}, {x, out.height - 26}, {ink, 2});
    out.text({layout.left, out.height - 12}, "time →", muted, Align::left);
    out.handle(handle);
    out.say(c.share > 0 ? "{} tiles keep the ranks busy {.1} % of the time."
                        : "{} slices keep the ranks busy {.1} % of the time.",
            static_cast<double>(tiles), 100 * found.efficiency);
}

void drag(ScheduleControls& c, const Drag& to) {
    const ScheduleLayout layout = schedule_layout(c, to.width);
    for (const auto& [rank, asks, begins, ends, is_copy] : schedule_of(c).schedule)
        if (rank == static_cast<int>(c.ranks) - 1) {
            const double more =
                to.moved().x / (layout.place(ends, 0).x - layout.place(begins, 0).x);
            c.slow = std::round(20 * c.slow * (1 + more)) / 20;
            return;
        }
}

}  // namespace live
