// The live figures of chapter 06.
#include <array>

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

}  // namespace live
