#pragma once
// The figure: the scene, which worker rendered what, how long each worker waited, and the speed-up.

#include <app/figure.hpp>
#include <cstdio>
#include <string>
#include <tuple>

#include "schedule.hpp"

namespace threads {

using app::Box, app::Figure;

inline const Color paper = from_hex(0x14161f), faint = from_hex(0x2a2e3d), ink = from_hex(0xd9d4c7),
                   dim = from_hex(0x767b8c), slices_color = from_hex(0xf2a541),
                   tiles_color = from_hex(0x57c4ad);

inline Color color_of(int worker) {
    const std::uint32_t colors[] = {0xf25f5c, 0xf2a541, 0xf6e27f, 0x57c4ad,
                                    0x4d9de0, 0xb388eb, 0xe56b9f, 0x9bc53d};
    return from_hex(colors[worker % 8]);
}

// Where everything is, in the figure's own units.
constexpr Real figure_width = 960, figure_height = 540;
constexpr Box scene_box{20, 20, 640, 360}, slices_map{680, 40, 260, 146},
    tiles_map{680, 234, 260, 146}, slices_bars{92, 402, 568, 54}, tiles_bars{92, 470, 568, 54},
    plot{706, 408, 226, 88};

// What the figure shows beside the scene.
struct Curve {
    std::vector<double> speed_up;  // with 1, 2, 3, ... workers; 0 where it was not measured
    const char* name;
    Color color;
    Vec2 label;  // from the curve's end to the top right corner of its name
};
struct Schedules {
    Schedule slices, tiles;
    std::vector<Curve> curves;
    std::string clock;  // the unit of time
};

// Draws the scene's light and shadow in the colors of the workers.
inline void draw_map(Figure map, const Image& scene, const Schedule& schedule) {
    std::vector<int> owner(scene.pixels().size());
    const auto index = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width()) +
               static_cast<std::size_t>(x);
    };
    for (const Span& span : schedule.spans)
        for_each_pixel(span.tile, [&](int x, int y) { owner[index(x, y)] = span.worker; });
    const auto place = [](Real t, int part, int all) {
        return std::clamp(static_cast<int>(t / static_cast<Real>(part) * static_cast<Real>(all)), 0,
                          all - 1);
    };
    const auto shade = [&](Real column, Real row) {
        const int x = place(column, map.columns(), scene.width());
        const int y = place(row, map.rows(), scene.height());
        const Color& light = scene.at(x, y);
        const Real gray = std::min(
            Real(1), Real(0.2126) * light.r + Real(0.7152) * light.g + Real(0.0722) * light.b);
        return color_of(owner[index(x, y)]) * (Real(0.16) + Real(0.84) * gray);
    };
    map.fill([&](int column, int row) { return app::average_of_nine(column, row, shade); });
}

// Draws a bar for each worker: in the worker's color while it works, hatched while it waits for the
// others.
inline void draw_bars(Figure& figure, const Box& box, const Schedule& schedule, double longest) {
    if (!(longest > 0)) return;
    const Real pitch = box.height / static_cast<Real>(schedule.workers);
    const auto x_of = [&](double t) {
        return box.left + box.width * static_cast<Real>(t / longest);
    };
    const auto bar = [&](int worker, double begin, double end) {
        return figure.part({x_of(begin), box.top + pitch * static_cast<Real>(worker),
                            x_of(end) - x_of(begin), pitch * Real(0.76)});
    };
    for (int worker = 0; worker < schedule.workers; ++worker)
        bar(worker, schedule.end_of(worker), schedule.end()).fill([&](int x, int y) {
            return (x + y) % 6 < 2 ? dim * Real(0.6) : faint;
        });
    std::vector<int> count(static_cast<std::size_t>(schedule.workers));
    for (const Span& span : schedule.spans) {
        const bool even = count[static_cast<std::size_t>(span.worker)]++ % 2 == 0;
        const Color color = color_of(span.worker) * (even ? Real(1) : Real(0.78));
        bar(span.worker, span.begin, span.end).fill([&](int, int) { return color; });
    }
}

inline void draw_speed_up(Figure& figure, const Box& box, const std::vector<Curve>& curves) {
    const auto most = static_cast<Real>(std::max<std::size_t>(2, curves.front().speed_up.size()));
    const auto place = [&](Real workers, Real speed_up) {
        return Vec2{box.left + box.width * (workers - 1) / (most - 1),
                    box.top + box.height * (1 - speed_up / most)};
    };
    const app::Lettering letters{8, dim};
    const int step = std::max(1, static_cast<int>(most) / 4);
    for (int i = 0; i <= static_cast<int>(most); i += step) {
        const Vec2 from = place(1, static_cast<Real>(i)), to = place(most, static_cast<Real>(i));
        figure.line(from, to, faint, Real(0.8));
        figure.words_before({from.x - 6, from.y - 4}, std::to_string(i), letters);
    }
    // The marks are at 1 and at the multiples of the step.
    for (int i = 1; i <= static_cast<int>(most); i += i < step ? step - i : step) {
        const Vec2 at = place(static_cast<Real>(i), 0);
        figure.line(at, {at.x, at.y + 3}, dim, Real(0.8));
        figure.words_around({at.x, at.y + 10}, std::to_string(i), letters);
    }
    figure.words_around({box.center().x, box.bottom() + 23}, "Workers", letters);
    figure.line(place(1, 1), place(most, most), dim);
    for (const Curve& curve : curves) {
        Vec2 last{};
        for (std::size_t i = 0; i < curve.speed_up.size(); ++i) {
            if (!(curve.speed_up[i] > 0)) continue;
            const Vec2 here = place(static_cast<Real>(i + 1), static_cast<Real>(curve.speed_up[i]));
            if (last != Vec2{}) figure.line(last, here, curve.color, Real(1.4));
            figure.dot(here, Real(2.4), curve.color);
            last = here;
        }
        figure.words_before({last.x + curve.label.x, last.y + curve.label.y}, curve.name,
                            {Real(7.2), curve.color});
    }
}

inline void draw_figure(Figure& figure, const Image& scene, const Schedules& shown) {
    figure.part(scene_box).fill([&](int x, int y) { return scene.at(x, y); });
    const double longest = std::max(shown.slices.end(), shown.tiles.end());
    for (const auto& [name, schedule, color, map, bars] :
         {std::tuple{"Slices", &shown.slices, slices_color, slices_map, slices_bars},
          std::tuple{"Tiles", &shown.tiles, tiles_color, tiles_map, tiles_bars}}) {
        draw_map(figure.part(map), scene, *schedule);
        char waiting[32];
        std::snprintf(waiting, sizeof waiting, "waiting %.2f of the time", schedule->waiting());
        figure.words({map.left, map.top - 16}, name, {9, color});
        figure.words_before({map.right(), map.top - 15}, waiting, {Real(7.2), dim});
        draw_bars(figure, bars, *schedule, longest);
        figure.words({20, bars.center().y - Real(4.5)}, name, {9, color});
    }
    const Vec2 now{slices_bars.left, 532}, later{slices_bars.right(), now.y};
    figure.line(now, later, dim);
    for (const Real side : {-3, 3}) figure.line({later.x - 5, later.y + side}, later, dim);
    figure.words({20, now.y - 4}, "Time", {8, dim});
    draw_speed_up(figure, plot, shown.curves);
    figure.words({plot.left + 8, plot.top - 4}, "Speed-up", {Real(7.2), ink});
    figure.words({plot.left + 8, plot.top + 8}, "By " + shown.clock, {Real(6.3), dim});
}

}  // namespace threads
