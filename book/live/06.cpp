// The live figures of chapter 06.
#include <array>
#include <bit>
#include <rt/render_tiles.hpp>

#include "controls.hpp"
#include "live.hpp"
#include "scene.hpp"
#include "schedule.hpp"

namespace live {
namespace {

constexpr std::array<std::uint32_t, 12> worker_colors{0xf25f5c, 0xf2a541, 0xe8cf4a, 0x57c4ad,
                                                      0x4d9de0, 0xb388eb, 0xe56b9f, 0x9bc53d,
                                                      0xd98c5f, 0x7fd1e8, 0x8f9bff, 0xc9a66b};

std::uint32_t color_of(int worker) {
    return worker_colors[static_cast<std::size_t>(worker) % worker_colors.size()];
}

threads::SceneShader shader_of(const threads::Scene& scene, int columns, int rows, int samples) {
    return {scene, rt::make_camera(threads::scene_view(), columns, rows), samples, 8, 1};
}

// ---- Slices and tiles ----

// The scene's light and shadow, and how many rays each pixel takes.
struct Work {
    static constexpr int columns = 208, rows = 117;

    std::vector<rt::Real> brightness;
    threads::RayCounts rays;
};

Work find_work() {
    const threads::Scene scene = threads::make_scene();
    const threads::SceneShader shader = shader_of(scene, Work::columns, Work::rows, 2);
    std::vector<rt::Real> brightness;
    std::vector<std::uint32_t> rays;
    for (int y = 0; y < Work::rows; ++y)
        for (int x = 0; x < Work::columns; ++x) {
            const auto [color, count] = shader(x, y);
            brightness.push_back(std::min(1.0, 0.21 * color.r + 0.72 * color.g + 0.07 * color.b));
            rays.push_back(static_cast<std::uint32_t>(count));
        }
    return {brightness, {Work::columns, Work::rows, rays}};
}

const Work& work() {
    static const Work found = find_work();
    return found;
}

struct Panel {
    Point corner;
    double width;
    int workers;

    double picture_height() const { return width * Work::rows / Work::columns; }
    double pitch() const { return std::clamp(108.0 / workers, 9.0, 18.0); }
    double bars() const { return corner.y + 26 + picture_height() + 12; }
    double bottom() const { return bars() + pitch() * workers; }
};

std::array<Panel, 2> panels_of(const WorkersControls& c, double width) {
    const int workers = static_cast<int>(c.workers);
    if (width < 520) {
        const Panel above{{0, 0}, width, workers};
        return {above, Panel{{0, above.bottom() + 14}, width, workers}};
    }
    const double half = (width - 24) / 2;
    return {Panel{{0, 0}, half, workers}, Panel{{half + 24, 0}, half, workers}};
}

// What has been drawn by this time, in the colors of the workers that drew it.
void draw_progress(Drawing& out, const Panel& panel, const threads::Schedule& schedule,
                   double now) {
    Bytes& map = out.picture(Work::columns, Work::rows);
    const rt::Color night = rt::from_hex(0x1d202b);
    for (int y = 0; y < Work::rows; ++y)
        for (int x = 0; x < Work::columns; ++x) map.set(x, y, night);
    const double scale = panel.width / Work::columns;
    const Point corner = panel.corner + Point{0, 26};
    const auto place = [&](int x, int y) { return corner + scale * Point{1.0 * x, 1.0 * y}; };
    std::vector<const threads::Span*> busy;
    for (const threads::Span& span : schedule.spans) {
        if (span.begin >= now) continue;
        const rt::Tile& tile = span.tile;
        if (span.end > now) busy.push_back(&span);
        const rt::Color color = rt::from_hex(color_of(span.worker));
        for (int y = tile.top; y < tile.bottom; ++y) {
            if (span.begin + work().rays.in({tile.left, tile.top, tile.right, y + 1}) > now) break;
            for (int x = tile.left; x < tile.right; ++x) {
                const auto pixel = static_cast<std::size_t>(y * Work::columns + x);
                map.set(x, y, color * (0.1 + 0.9 * work().brightness[pixel]));
            }
        }
    }
    out.show(map, corner, place(Work::columns, Work::rows));
    for (const threads::Span* span : busy)
        out.frame(place(span->tile.left, span->tile.top),
                  place(span->tile.right, span->tile.bottom), {rgb(color_of(span->worker)), 2});
}

// A bar for each worker: what it draws, tile by tile, then hatched while it waits.
void draw_bars(Drawing& out, const Panel& panel, const threads::Schedule& schedule, double longest,
               double now) {
    const double high = 0.76 * panel.pitch();
    const auto place = [&](double time, int worker) {
        return Point{panel.corner.x + panel.width * time / longest,
                     panel.bars() + panel.pitch() * worker};
    };
    for (const threads::Span& span : schedule.spans) {
        const Ink color = rgb(color_of(span.worker));
        const Point from = place(span.begin, span.worker), to = place(span.end, span.worker);
        const Point end{to.x - (to.x - from.x > 3 ? 1 : 0), to.y + high};
        out.box(from, end, thin(color, 0.25));
        if (span.begin < now) out.box(from, {std::min(end.x, place(now, 0).x), end.y}, color);
    }
    for (int worker = 0; worker < schedule.workers; ++worker) {
        const Point from = place(schedule.end_of(worker), worker),
                    to = place(schedule.end(), worker) + Point{0, high};
        for (double x = from.x + 5; x < to.x; x += 6)
            out.line({x - 3, to.y}, {x, from.y}, {thin(muted, 0.7), 1.2});
    }
    const double x = place(now, 0).x;
    out.line({x, panel.bars() - 6}, {x, panel.bottom() + 2}, {ink, 2});
    out.disc({x, panel.bars() - 6}, 4.5, ink);
}

}  // namespace

void draw(const WorkersControls& c, Drawing& out) {
    const int workers = static_cast<int>(c.workers), size = 4 << static_cast<int>(c.size);
    const rt::TileGrid grid{Work::columns, Work::rows, size};
    const threads::Schedule slices = threads::slices_by_rays(work().rays, grid, workers),
                            tiles = threads::tiles_by_rays(work().rays, grid, workers);
    const double longest = std::max(slices.end(), tiles.end()), now = c.time / 100 * longest;
    const double perfect =
        work().rays.in({0, 0, Work::columns, Work::rows}) / static_cast<double>(workers);
    const auto panels = panels_of(c, out.width);
    out.height = panels[1].bottom() + 6;

    for (const bool is_tiles : {false, true}) {
        const Panel& panel = panels[is_tiles];
        const threads::Schedule& schedule = is_tiles ? tiles : slices;
        draw_progress(out, panel, schedule, now);
        draw_bars(out, panel, schedule, longest, now);
        out.bold = true;
        out.text(panel.corner + Point{0, 12}, is_tiles ? "Tiles of {} × {}" : "Slices", ink,
                 Align::left, size, size);
        out.bold = false;
        int waiting = 0;
        for (int worker = 0; worker < workers; ++worker) waiting += schedule.end_of(worker) <= now;
        out.text(panel.corner + Point{panel.width, 12},
                 now >= schedule.end() ? "done"
                 : waiting             ? "waiting: {} of {}"
                                       : "all at work",
                 waiting && now < schedule.end() ? orange : muted, Align::right, waiting, workers);
    }
    out.handle_everywhere();
    out.say(
        "Slices take {.2} times as long as if nobody ever waited, and {.0} % of the workers’ "
        "time is spent waiting; tiles take {.2} times as long, with {.1} %.",
        slices.end() / perfect, 100 * slices.waiting(), tiles.end() / perfect,
        100 * tiles.waiting());
}

void drag(WorkersControls& c, const Drag& to) {
    c.time += 100 * to.moved().x / panels_of(c, to.width)[0].width;
}

// ---- Whose random numbers a sample draws ----

namespace {

constexpr int small_columns = 144, small_rows = 81, few = 4;

enum class Owner { sample, worker, all };

// The order in which the workers begin their tiles. A tile takes a different time in each run.
threads::Schedule schedule_of(const rt::TileGrid& grid, int workers, int run) {
    rt::Rng haste{static_cast<std::uint64_t>(run), 6};
    std::vector<std::uint32_t> times(static_cast<std::size_t>(grid.width * grid.height));
    for (std::uint32_t& time : times) time = 900 + haste() % 200;
    return threads::tiles_by_rays({grid.width, grid.height, times}, grid, workers);
}

std::vector<rt::Color> picture_of(Owner owner, int workers, int run) {
    const threads::Scene scene = threads::make_scene();
    const threads::SceneShader shader = shader_of(scene, small_columns, small_rows, few);
    const rt::TileGrid grid{small_columns, small_rows, 8};
    std::vector<rt::Rng> generators;
    for (int worker = 0; worker < workers; ++worker)
        generators.push_back(rt::pixel_rng(1, worker, 0));

    std::vector<rt::Color> picture(static_cast<std::size_t>(small_columns * small_rows));
    for (const threads::Span& span : schedule_of(grid, workers, run).spans) {
        rt::Rng& shared =
            generators[owner == Owner::all ? 0 : static_cast<std::size_t>(span.worker)];
        rt::for_each_pixel(span.tile, [&](int x, int y) {
            rt::ColorSum sum;
            for (int sample = 0; sample < few; ++sample) {
                rt::Rng own = rt::sample_rng(1, x, y, sample);
                sum.add(shader.sample(scene.world, x, y, sample,
                                      owner == Owner::sample ? own : shared));
            }
            picture[static_cast<std::size_t>(y * small_columns + x)] = sum.mean(few);
        });
    }
    return picture;
}

}  // namespace

void draw(const StreamsControls& c, Drawing& out) {
    const auto owner = static_cast<Owner>(static_cast<int>(c.owner));
    static std::array<std::vector<rt::Color>, 3> alone;  // what one worker draws
    std::vector<rt::Color>& expected = alone[static_cast<std::size_t>(c.owner)];
    if (expected.empty()) expected = picture_of(owner, 1, 1);
    const auto picture = picture_of(owner, static_cast<int>(c.workers), static_cast<int>(c.run));

    Bytes &shown = out.picture(small_columns, small_rows),
          &difference = out.picture(small_columns, small_rows);
    int differ = 0;
    for (int y = 0; y < small_rows; ++y)
        for (int x = 0; x < small_columns; ++x) {
            const auto pixel = static_cast<std::size_t>(y * small_columns + x);
            const rt::Color now = picture[pixel], then = expected[pixel];
            differ += now != then;
            shown.set(x, y, now);
            difference.set(x, y,
                           {4 * std::abs(now.r - then.r), 4 * std::abs(now.g - then.g),
                            4 * std::abs(now.b - then.b)});
        }
    const bool narrow = out.is_narrow();
    const double wide = narrow ? out.width : (out.width - 16) / 2,
                 high = wide * small_rows / small_columns;
    const Point first{0, 26}, second = narrow ? Point{0, high + 60} : Point{wide + 16, 26};
    const Point size{wide, high};
    out.height = second.y + high + 4;
    out.bold = true;
    out.text(first + Point{0, -14}, "Run {}", ink, Align::left, c.run);
    out.text(second + Point{0, -14}, "Difference, times 4", ink, Align::left);
    out.show(shown, first, first + size, false);
    out.show(difference, second, second + size, false);
    if (differ == 0) {
        out.on_picture = true;
        out.text(second + 0.5 * size, "the same to the last bit", ink);
        out.on_picture = false;
    }
    out.bold = false;
    out.handle_everywhere();
    const double share = 100.0 * differ / (small_columns * small_rows);
    if (differ == 0)
        out.say("Run {}, workers: {}. No pixel differs from what one worker draws.", c.run,
                c.workers);
    else
        out.say("Run {}, workers: {}. {.0} % of the pixels differ from what one worker draws.",
                c.run, c.workers, share);
}

void drag(StreamsControls& c, const Drag& to) {
    c.run = std::round(c.run + 12 * to.moved().x / to.width);
}

// ---- Two threads and a counter ----

namespace {

constexpr int tiles = 6;
constexpr std::array<Ink, 2> thread_inks{blue, orange};

enum class Did { nothing, read, add, write, take };

struct Step {
    int thread;
    Did did = Did::nothing;  // nothing if the thread had ended
    int value = 0;           // that it read, computed or wrote, or the tile that it took
    int lost = 0;            // counts that its write undid
};

// What two threads do that take tiles until none is left, in a given order of their steps.
struct Run {
    struct Thread {
        int done = 0;  // instructions of the three, since it began to take this tile
        int mine = 0, sum = 0;
        bool has_ended = false;
    };
    std::array<Thread, 2> threads{};
    std::atomic<int> next = 0;
    std::array<std::array<int, 2>, tiles> rendered{};  // how often each thread rendered each tile
    std::vector<Step> steps;
    int lost = 0;

    void read_add_or_write(int number) {
        Thread& thread = threads[static_cast<std::size_t>(number)];
        Step step{number};
        if (thread.done == 3) thread.done = 0;
        if (thread.done == 0) {
            step.did = Did::read, step.value = thread.mine = next;
        } else if (thread.done == 1) {
            step.did = Did::add, step.value = thread.sum = thread.mine + 1;
        } else {
            step.did = Did::write, step.value = thread.sum;
            step.lost = next - thread.mine;
            lost += step.lost;
            next = thread.sum;
            render(number, thread.mine);
        }
        ++thread.done;
        steps.push_back(step);
    }
    void take(int number) {
        const std::optional<int> tile = rt::take_tile(next, tiles);
        Thread& thread = threads[static_cast<std::size_t>(number)];
        thread.mine = tile.value_or(next - 1);
        thread.done = 1;
        steps.push_back({number, Did::take, thread.mine});
        render(number, tile.value_or(tiles));
    }
    void render(int number, int tile) {
        const auto thread = static_cast<std::size_t>(number);
        if (tile >= tiles)
            threads[thread].has_ended = true;
        else
            ++rendered[static_cast<std::size_t>(tile)][thread];
    }
};

void run_turns(const CounterControls& c, Run& run) {
    const auto turns = static_cast<std::uint64_t>(std::max(1.0, c.turns));
    for (int bit = std::bit_width(turns) - 2; bit >= 0; --bit) {
        const int thread = static_cast<int>(turns >> bit & 1);
        if (run.threads[static_cast<std::size_t>(thread)].has_ended)
            run.steps.push_back({thread});
        else if (c.how == 0)
            run.read_add_or_write(thread);
        else
            run.take(thread);
    }
}

struct CounterLayout {
    double side;  // the width of a thread's box
    std::array<Point, 2> corner;
    Point counter;  // its middle
    double row, bottom;
};

CounterLayout counter_layout(double width, bool is_atomic) {
    const double side = 0.37 * width, row = 30, top = 26,
                 bottom = top + (is_atomic ? 1 : 3) * row + 12;
    return {
        side, {{{1, top}, {width - side - 1, top}}}, {width / 2, (top + bottom) / 2}, row, bottom};
}

void draw_thread(Drawing& out, const CounterLayout& layout, const Run& run, int number,
                 bool is_atomic) {
    const auto& thread = run.threads[static_cast<std::size_t>(number)];
    const Point corner = layout.corner[static_cast<std::size_t>(number)],
                opposite{corner.x + layout.side, layout.bottom};
    const Ink color = thread_inks[static_cast<std::size_t>(number)];
    out.box(corner, opposite, thin(color, thread.has_ended ? 0.05 : 0.12));
    out.frame(corner, opposite, {thread.has_ended ? faint : color, 1.5});
    out.bold = true;
    out.text({(corner.x + opposite.x) / 2, 12},
             thread.has_ended ? "Thread {} has ended" : "Thread {}", color, Align::middle, number);
    out.bold = false;
    constexpr std::array words{"read next", "add 1", "write next"};
    const int instructions = is_atomic ? 1 : 3, to_do = is_atomic ? 0 : thread.done % 3;
    for (int i = 0; i < instructions; ++i) {
        const double y = corner.y + 6 + layout.row * (i + 0.5);
        const bool is_next = !thread.has_ended && i == to_do;
        if (is_next)
            out.polygon({{corner.x + 6, y - 5}, {corner.x + 14, y}, {corner.x + 6, y + 5}}, color);
        out.text({corner.x + 20, y},
                 is_atomic ? "fetch_add(1)" : words[static_cast<std::size_t>(i)],
                 is_next ? ink : muted, Align::left);
        if (i < thread.done)
            out.text({opposite.x - 10, y}, "{}", ink, Align::right,
                     i == 0 ? thread.mine : thread.sum);
    }
    if (!run.steps.empty() && run.steps.back().thread == number &&
        run.steps.back().did != Did::nothing && run.steps.back().did != Did::add) {
        const bool reads = run.steps.back().did == Did::read;
        const double way = number == 0 ? 1 : -1;
        const Point outer{number == 0 ? opposite.x + 4 : corner.x - 4, layout.counter.y},
            inner{layout.counter.x - way * 30, layout.counter.y};
        if (run.steps.back().did != Did::write) out.arrow(inner, outer, {color, 2.5});
        if (!reads) out.arrow(outer, inner, {color, 2.5});
    }
}

// The latest steps, in a row for each thread.
double draw_steps(Drawing& out, const Run& run, double top) {
    const double wide = 27, high = 22, left = 62;
    const auto room = static_cast<std::size_t>((out.width - left) / wide);
    const std::size_t first = run.steps.size() > room ? run.steps.size() - room : 0;
    for (const int thread : {0, 1}) {
        const double y = top + (high + 4) * (thread + 0.5);
        out.text({1, y}, "Thread {}", thread_inks[static_cast<std::size_t>(thread)], Align::left,
                 thread);
        out.line({left, y}, {out.width, y}, {faint, 1});
    }
    out.text_size = 12;
    for (std::size_t i = first; i < run.steps.size(); ++i) {
        const Step& step = run.steps[i];
        if (step.did == Did::nothing) continue;
        const Ink color = thread_inks[static_cast<std::size_t>(step.thread)];
        const Point corner{left + wide * static_cast<double>(i - first) + 1,
                           top + (high + 4) * step.thread + 2},
            opposite = corner + Point{wide - 2, high};
        out.box(corner, opposite, paper);
        out.box(corner, opposite, thin(color, 0.15));
        out.frame(corner, opposite, {step.lost > 0 ? pink : color, step.lost > 0 ? 3.0 : 1.2});
        out.text(0.5 * (corner + opposite),
                 step.did == Did::read    ? "r {}"
                 : step.did == Did::add   ? "+1"
                 : step.did == Did::write ? "w {}"
                                          : "{}",
                 ink, Align::middle, step.value);
    }
    out.text_size = 13;
    return top + 2 * (high + 4);
}

double draw_tiles(Drawing& out, const Run& run, double top) {
    const double left = 62, side = std::min(58.0, (out.width - left) / tiles), high = 38;
    out.text({1, top + high / 2}, "Tiles", muted, Align::left);
    for (int tile = 0; tile < tiles; ++tile) {
        const auto& by = run.rendered[static_cast<std::size_t>(tile)];
        const Point corner{left + side * tile + 2, top}, opposite = corner + Point{side - 4, high};
        const int times = by[0] + by[1];
        for (const int thread : {0, 1}) {
            if (by[static_cast<std::size_t>(thread)] == 0) continue;
            const double from = thread == 1 && by[0] > 0 ? 0.5 : 0,
                         to = thread == 0 && by[1] > 0 ? 0.5 : 1;
            out.box(corner + Point{from * (side - 4), 0}, {corner.x + to * (side - 4), opposite.y},
                    thin(thread_inks[static_cast<std::size_t>(thread)], 0.35));
        }
        out.frame(corner, opposite,
                  {times > 1    ? pink
                   : times == 1 ? ink
                                : faint,
                   times > 1 ? 3.0 : 1.2});
        out.text(corner + Point{(side - 4) / 2, high / 2}, times > 1 ? "{}: {}×" : "{}",
                 times > 0 ? ink : muted, Align::middle, tile, times);
    }
    return top + high;
}

}  // namespace

void draw(const CounterControls& c, Drawing& out) {
    Run run;
    run_turns(c, run);
    const bool is_atomic = c.how > 0;
    const CounterLayout layout = counter_layout(out.width, is_atomic);
    for (const int thread : {0, 1}) draw_thread(out, layout, run, thread, is_atomic);
    const Point middle = layout.counter;
    out.box(middle - Point{24, 15}, middle + Point{24, 15}, panel);
    out.frame(middle - Point{24, 15}, middle + Point{24, 15}, {ink, 1.5});
    out.text({middle.x, 12}, "next", ink);
    out.text_size = 16, out.bold = true;
    out.text(middle, "{}", ink, Align::middle, run.next.load());
    out.text_size = 13, out.bold = false;
    const double below = draw_steps(out, run, layout.bottom + 14);
    out.height = draw_tiles(out, run, below + 12) + 4;
    out.handle_everywhere();

    int twice = 0, none = 0;
    for (const auto& by : run.rendered) {
        twice += by[0] + by[1] > 1;
        none += by[0] + by[1] == 0;
    }
    if (run.steps.empty()) {
        out.say("Both threads are about to take their first tile.");
    } else if (run.threads[0].has_ended && run.threads[1].has_ended) {
        out.say(twice > 0 ? "Both have ended. Counts lost: {}; tiles rendered more than once: {}."
                          : "Both have ended. Counts lost: {}. Each tile was rendered once.",
                run.lost, twice);
    } else if (const Step& step = run.steps.back(); step.lost > 0) {
        out.say("Thread {} writes {}. The counter was {}: counts lost: {}.", step.thread,
                step.value, step.value - 1 + step.lost, step.lost);
    } else if (run.threads[static_cast<std::size_t>(step.thread)].has_ended) {
        out.say("Thread {} ends, because no tile is left for it.", step.thread);
    } else if (step.did == Did::read) {
        out.say("Thread {} reads {}.", step.thread, step.value);
    } else if (step.did == Did::add) {
        out.say("Thread {} computes {}. The counter still holds {}.", step.thread, step.value,
                run.next.load());
    } else if (step.did == Did::write) {
        out.say("Thread {} writes {}, and renders tile {}.", step.thread, step.value,
                step.value - 1);
    } else {
        out.say("Thread {} takes tile {} and leaves {}, in one step.", step.thread, step.value,
                step.value + 1);
    }
}

void drag(CounterControls& c, const Drag& to) {
    if (c.turns < 0x1p52) c.turns = 2 * c.turns + (to.down.x > to.width / 2 ? 1 : 0);
}

}  // namespace live
