#pragma once
// The panels that show what memory costs: the time that a step through memory takes, and the time
// that making an object takes.

#include <rt/portable.hpp>
#include <string>
#include <vector>

#include "memory_times.hpp"
#include "panel.hpp"

namespace toolchain {

inline void draw_steps(Figure& figure, const app::Box& box, const std::vector<Steps>& all,
                       bool by_machine) {
    draw_panel(figure, box, by_machine ? "Time of a step here" : "Time of a step -- model");
    const app::Box plot{box.left + 40, box.top + 40, box.width - 58, box.height - 74};
    const int powers = 4;  // of ten, above a tenth of a nanosecond
    const auto place = [&](double bytes, double ns) {
        const Real across = static_cast<Real>(rt::portable::log2(bytes / smallest) / 16);
        const Real up = static_cast<Real>(rt::portable::log10(ns * 10) / powers);
        return Vec2{plot.left + plot.width * across,
                    plot.bottom() - plot.height * std::clamp(up, Real(0), Real(1))};
    };
    const char* const times[] = {"0.1", "1", "10", "100", "1000"};
    for (int i = 0; i <= powers; ++i) {
        const Real y = plot.bottom() - plot.height * static_cast<Real>(i) / powers;
        figure.line({plot.left, y}, {plot.right(), y}, ink, Real(0.7), Real(0.18));
        const std::string label = times[i];
        figure.words_before({plot.left - 8, y - 3}, label, {6, faint});
    }
    figure.words({plot.left - 28, plot.top - 14}, "ns", {6, faint});
    const char* const sizes[] = {"1K", "16K", "256K", "4M", "64M"};
    for (int i = 0; i < 5; ++i) {
        const Real x = plot.left + plot.width * static_cast<Real>(i) / 4;
        figure.words_around({x, plot.bottom() + 13}, sizes[i], {6, faint});
    }
    figure.words_around({plot.left + plot.width / 2, plot.bottom() + 25}, "Bytes of the chain",
                        {6, faint});
    if (!by_machine)
        for (const Level& level : levels) {
            if (level.bytes > largest_size) continue;
            const Real x = place(level.bytes, 1).x;
            for (Real y = plot.top; y < plot.bottom(); y += 6)
                figure.line({x, y}, {x, y + 2}, faint, Real(0.8), Real(0.6));
            figure.words_around({x, plot.top - 8}, level.name, {6, faint});
        }
    const auto curve = [&](double Steps::*time, Color color) {
        for (std::size_t i = 1; i < all.size(); ++i)
            figure.line(place(all[i - 1].bytes, all[i - 1].*time),
                        place(all[i].bytes, all[i].*time), color, Real(1.8));
        for (const Steps& steps : all) figure.dot(place(steps.bytes, steps.*time), 3, color);
    };
    curve(&Steps::gathered, mint);
    curve(&Steps::scattered, rose);
    figure.words({plot.left + 12, plot.bottom() - 26}, "Gathered", {6, mint});
    const Vec2 middle = place(1 << 18, 1);
    // The word stands between two lines of the grid and between the lines of two caches.
    figure.words({middle.x + 40, plot.top + plot.height * Real(0.61)}, "Scattered", {6, rose});
}

inline void draw_objects(Figure& figure, const app::Box& box, const Objects& objects,
                         bool by_machine) {
    draw_panel(figure, box, by_machine ? "ns an object" : "Calls of new");
    const char* const names[] = {"Stack", "Heap", "At once"};
    const Color colors[] = {gold, rose, mint};
    const double values[] = {by_machine ? objects.stack : 0, by_machine ? objects.heap : 1000,
                             by_machine ? objects.together : 1};
    const Real base = box.bottom() - 30, room = box.height - 84, pitch = (box.width - 30) / 3;
    const double most = *std::max_element(values, values + 3);
    for (int i = 0; i < 3; ++i) {
        const Real left = box.left + 15 + pitch * static_cast<Real>(i);
        const Real height =
            std::max<Real>(Real(1.5), room * static_cast<Real>(values[i] / std::max(most, 1e-9)));
        figure.box({left + 8, base - height, pitch - 16, height}, colors[i], Real(0.9), 2);
        char text[16];
        std::snprintf(text, sizeof text, by_machine ? "%.1f" : "%.0f", values[i]);
        figure.words_around({left + pitch / 2, base - height - 9}, text, {7, ink});
        figure.words_around({left + pitch / 2, base + 12}, names[i], {6, faint});
    }
    if (!by_machine) figure.words({box.left + 12, box.top + 26}, "For 1000 objects", {6, faint});
}

}  // namespace toolchain
