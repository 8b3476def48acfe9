#pragma once
// The poster: the scene, who rendered what, how long each worker waited, and the speed-up.

#include <cstdio>
#include <string>
#include <tuple>

#include "schedule.hpp"
#include "sheet.hpp"

namespace threads {

inline const Color paper = from_hex(0x14161f), faint = from_hex(0x2a2e3d), ink = from_hex(0xd9d4c7),
                   dim = from_hex(0x767b8c), slices_color = from_hex(0xf2a541),
                   tiles_color = from_hex(0x57c4ad);

inline Color color_of(int worker) {
    const std::uint32_t colors[] = {0xf25f5c, 0xf2a541, 0xf6e27f, 0x57c4ad,
                                    0x4d9de0, 0xb388eb, 0xe56b9f, 0x9bc53d};
    return from_hex(colors[worker % 8]);
}

struct Curve {
    std::vector<double> speed_up;  // of 1, 2, 3, ... workers; 0 where it is not known
    Color color;
};

// Where things are on the poster; all of it scales with the picture.
struct Layout {
    Real s;  // pixels of a unit; the poster is 960 x 540 of them
    Box scene, slices_map, tiles_map, slices_bars, tiles_bars, plot;

    Layout(int width, int height)
        : s{std::min(static_cast<Real>(width) / 960, static_cast<Real>(height) / 540)} {
        scene = at(20, 20, 640, 360);
        slices_map = at(680, 40, 260, 146);
        tiles_map = at(680, 234, 260, 146);
        slices_bars = at(92, 402, 568, 54);
        tiles_bars = at(92, 470, 568, 54);
        plot = at(706, 408, 226, 88);
    }
    Box at(Real left, Real top, Real width, Real height) const {
        return {left * s, top * s, width * s, height * s};
    }
    // The grid of the scene's pixels; at least one.
    TileGrid grid(int tile_size) const {
        const auto side = [](Real length) {
            return std::max(1, static_cast<int>(std::lround(length)));
        };
        return {side(scene.width), side(scene.height), tile_size};
    }
};

// The scene's light and shadow in the colors of the workers.
inline void draw_map(Sheet& sheet, const Box& box, const Image& scene, const Schedule& schedule) {
    std::vector<int> owner(scene.pixels().size());
    std::vector<bool> edge(owner.size());
    for (const Span& span : schedule.spans)
        for (int y = span.tile.top; y < span.tile.bottom; ++y)
            for (int x = span.tile.left; x < span.tile.right; ++x)
                owner[static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width()) +
                      static_cast<std::size_t>(x)] = span.worker;
    sheet.paint(box, [&](int column, int row) {
        // The average of the scene's pixels below this one, nearly: 3 x 3 places.
        Color sum;
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) {
                const auto place = [](int k, int part, Real length, int pixels) {
                    const Real t =
                        (static_cast<Real>(k) + (static_cast<Real>(part) + Real(0.5)) / 3) / length;
                    return std::clamp(static_cast<int>(t * static_cast<Real>(pixels)), 0,
                                      pixels - 1);
                };
                const int x = place(column, i, box.width, scene.width());
                const int y = place(row, j, box.height, scene.height());
                const Color& light = scene.at(x, y);
                const Real gray =
                    std::min(Real(1), Real(0.2126) * light.r + Real(0.7152) * light.g +
                                          Real(0.0722) * light.b);
                const int worker =
                    owner[static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width()) +
                          static_cast<std::size_t>(x)];
                sum += color_of(worker) * (Real(0.16) + Real(0.84) * gray);
            }
        return sum / 9;
    });
}

// A bar for each worker: in its color while it works, hatched while it waits for the others.
inline void draw_bars(Sheet& sheet, const Box& box, const Schedule& schedule, double longest) {
    if (!(longest > 0)) return;
    const Real pitch = box.height / static_cast<Real>(schedule.workers);
    const auto x_of = [&](double t) {
        return box.left + box.width * static_cast<Real>(t / longest);
    };
    const auto bar = [&](int worker, double begin, double end) {
        return Box{x_of(begin), box.top + pitch * static_cast<Real>(worker),
                   x_of(end) - x_of(begin), pitch * Real(0.76)};
    };
    for (int worker = 0; worker < schedule.workers; ++worker) {
        const Box waits = bar(worker, schedule.end_of(worker), schedule.end());
        sheet.paint(waits, [&](int x, int y) { return (x + y) % 6 < 2 ? dim * Real(0.6) : faint; });
    }
    std::vector<int> count(static_cast<std::size_t>(schedule.workers));
    for (const Span& span : schedule.spans) {
        const bool even = count[static_cast<std::size_t>(span.worker)]++ % 2 == 0;
        sheet.fill(bar(span.worker, span.begin, span.end),
                   color_of(span.worker) * (even ? Real(1) : Real(0.78)));
    }
}

inline void draw_speed_up(Sheet& sheet, const Box& box, Real s, const std::vector<Curve>& curves) {
    const auto most = static_cast<Real>(std::max<std::size_t>(2, curves.front().speed_up.size()));
    const auto place = [&](Real workers, Real speed_up) {
        return Vec2{box.left + box.width * (workers - 1) / (most - 1),
                    box.top + box.height * (1 - speed_up / most)};
    };
    const Real letters = 8 * s;
    const int step = std::max(1, static_cast<int>(most) / 4);
    for (int i = 0; i <= static_cast<int>(most); i += step) {
        const Vec2 from = place(1, static_cast<Real>(i)), to = place(most, static_cast<Real>(i));
        sheet.line(from, to, s * Real(0.8), faint);
        const std::string number = std::to_string(i);
        sheet.words(from.x - Sheet::width_of(number, letters) - 4 * s, from.y - letters / 2,
                    letters, number, dim);
    }
    // 1, and then the multiples of the step.
    for (int i = 1; i <= static_cast<int>(most); i += i < step ? step - i : step) {
        const Vec2 at = place(static_cast<Real>(i), 0);
        const std::string number = std::to_string(i);
        sheet.line(at, {at.x, at.y + 3 * s}, s * Real(0.8), dim);
        sheet.words(at.x - Sheet::width_of(number, letters) / 2, at.y + 6 * s, letters, number,
                    dim);
    }
    const std::string_view below = "WORKERS";
    sheet.words(box.left + (box.width - Sheet::width_of(below, letters)) / 2,
                box.top + box.height + 19 * s, letters, below, dim);
    sheet.line(place(1, 1), place(most, most), s, dim);
    for (const Curve& curve : curves) {
        Vec2 last{};
        for (std::size_t i = 0; i < curve.speed_up.size(); ++i) {
            if (!(curve.speed_up[i] > 0)) continue;
            const Vec2 here = place(static_cast<Real>(i + 1), static_cast<Real>(curve.speed_up[i]));
            if (last != Vec2{}) sheet.line(last, here, s * Real(1.4), curve.color);
            sheet.dot(here, s * Real(2.4), curve.color);
            last = here;
        }
    }
}

inline Image draw_poster(int width, int height, const Layout& layout, const Image& scene,
                         const Schedule& slices, const Schedule& tiles,
                         const std::vector<Curve>& curves, const std::string& clock) {
    Sheet sheet{width, height, paper};
    const Real s = layout.s, letters = 9 * s;
    sheet.paint(layout.scene, [&](int x, int y) {
        return scene.at(std::min(x, scene.width() - 1), std::min(y, scene.height() - 1));
    });
    draw_map(sheet, layout.slices_map, scene, slices);
    draw_map(sheet, layout.tiles_map, scene, tiles);
    const auto waiting = [](const Schedule& schedule) {
        char text[32];
        std::snprintf(text, sizeof text, "WAITING %.2f OF THE TIME", schedule.waiting());
        return std::string(text);
    };
    const auto title = [&](const Box& map, const char* name, const Schedule& schedule,
                           Color color) {
        sheet.words(map.left, map.top - 16 * s, letters, name, color);
        const std::string right = waiting(schedule);
        sheet.words(map.left + map.width - Sheet::width_of(right, letters * Real(0.8)),
                    map.top - 15 * s, letters * Real(0.8), right, dim);
    };
    title(layout.slices_map, "SLICES", slices, slices_color);
    title(layout.tiles_map, "TILES", tiles, tiles_color);
    const double longest = std::max(slices.end(), tiles.end());
    draw_bars(sheet, layout.slices_bars, slices, longest);
    draw_bars(sheet, layout.tiles_bars, tiles, longest);
    for (const auto& [box, name, color] : {std::tuple{layout.slices_bars, "SLICES", slices_color},
                                           std::tuple{layout.tiles_bars, "TILES", tiles_color}})
        sheet.words(20 * s, box.top + box.height / 2 - letters / 2, letters, name, color);
    draw_speed_up(sheet, layout.plot, s, curves);
    sheet.words(layout.plot.left + 8 * s, layout.plot.top - 4 * s, letters * Real(0.8), "SPEED-UP",
                ink);
    sheet.words(layout.plot.left + 8 * s, layout.plot.top + 8 * s, letters * Real(0.7),
                "BY " + clock, dim);
    return std::move(sheet.image);
}

}  // namespace threads
