#pragma once
// The picture: what is where in memory, one chain in two memories, and what that costs in time.

#include <functional>
#include <rt/binary_tree.hpp>
#include <rt/canvas.hpp>
#include <rt/gradient.hpp>
#include <rt/range_node.hpp>
#include <string>

#include "measure.hpp"
#include "sheet.hpp"

namespace toolchain {

inline const Color ink = from_hex(0xfff4e0), faint = from_hex(0xe2d6ee), glass = from_hex(0x0c0a1c),
                   gold = from_hex(0xffd166), rose = from_hex(0xff6b8b), mint = from_hex(0x6ee7c8),
                   sky_blue = from_hex(0x7cc6fe);

// What the picture is drawn from.
struct Exhibits {
    const Canvas<Color>& canvas;  // a small picture on the heap
    const RangeNode* root = nullptr;
    std::vector<Steps> steps;
    Objects objects;
    bool by_machine = false;
    std::vector<std::string>
        addresses;  // of canvas, root, paint, pixels, corners, gradient; or none
};

// From blue over green and gold to rose as t goes from 0 to 1.
inline Color along_rainbow(Real t) {
    const Color colors[] = {sky_blue, mint, gold, rose};
    const Real place = std::clamp(t, Real(0), Real(1)) * 3;
    const int i = std::min(2, static_cast<int>(place));
    return mix(colors[i], colors[i + 1], place - static_cast<Real>(i));
}

inline void draw_panel(Sheet& sheet, const Box& box, std::string_view title) {
    sheet.box(box, glass, Real(0.84), 8);
    sheet.frame(box, ink, Real(0.16), 8);
    sheet.words(box.left + 12, box.top + 11, 8, title, ink);
}

// A variable: a name above, and a cell for each of its parts.
inline Box draw_cells(Sheet& sheet, Real left, Real top, std::string_view name,
                      const std::vector<std::string>& parts, Color color) {
    sheet.words(left, top, 6, name, color);
    Real x = left;
    for (const std::string& part : parts) {
        const Real width = std::max<Real>(22, Sheet::width_of(part, 6) + 10);
        sheet.box({x, top + 11, width, 20}, color, Real(0.16), 2);
        sheet.frame({x, top + 11, width, 20}, color, Real(0.8), 2);
        sheet.words_around({x + width / 2, top + 21}, 6, part, ink);
        x += width;
    }
    return {left, top + 11, x - left, 20};
}

// The nodes of a tree in their levels, with an arrow for each unique_ptr.
inline void draw_tree(Sheet& sheet, const RangeNode* node, const Box& box, int rows) {
    if (!node || rows <= 0) return;
    const Vec2 here{box.left + box.width / 2, box.top + 6};
    const Real step = (box.height - 12) / static_cast<Real>(std::max(1, rows - 1));
    const auto child = [&](const std::unique_ptr<RangeNode>& owner, Real left, Real width) {
        if (!owner || rows <= 1) return;
        const Box below{left, box.top + step, width, box.height - step};
        const Vec2 to{below.left + below.width / 2, below.top};
        sheet.arrow({here.x, here.y + 3}, {here.x, here.y + step / 2}, {to.x, to.y - step / 2}, to,
                    mint, 1);
        draw_tree(sheet, owner.get(), below, rows - 1);
    };
    const int count = node->last - node->first;
    const int left_count = node->left ? node->left->last - node->left->first : count / 2;
    const Real share = static_cast<Real>(left_count) / static_cast<Real>(std::max(1, count));
    child(node->left, box.left, box.width * share);
    child(node->right, box.left + box.width * share, box.width * (1 - share));
    const Box cell{here.x - 7, here.y - 6, 14, 12};
    sheet.box(cell, glass, 1, 2);
    sheet.box(cell, mint, node->left ? Real(0.35) : Real(0.85), 2);
    sheet.words_around(here, Real(6.5), std::to_string(count), node->left ? ink : glass);
}

// The four parts of the memory, each with a field of its own.
struct Segments {
    Box stack, heap, fixed, code;
};

inline Segments draw_segments(Sheet& sheet, const Box& panel) {
    const auto segment = [&](Real top, Real height, std::string_view name, std::string_view what,
                             Color color) {
        const Box b{panel.left + 12, panel.top + top, panel.width - 24, height};
        sheet.box(b, color, Real(0.10), 4);
        sheet.box({b.left, b.top, 3, b.height}, color, 1, 1);
        sheet.words(b.left + 12, b.top + 9, 8, name, color);
        // Beside the name, where no arrow comes down; else below.
        if (height < 100)
            sheet.words(b.left + 12 + Sheet::width_of(name, 8) + 12, b.top + 11, 5, what, faint);
        else
            sheet.words(b.left + 14, b.bottom() - 13, 5, what, faint);
        return b;
    };
    sheet.words(panel.right() - 12 - Sheet::width_of("HIGH ADDRESSES", 5), panel.top + 13, 5,
                "HIGH ADDRESSES", faint);
    sheet.words(panel.right() - 12 - Sheet::width_of("LOW ADDRESSES", 5), panel.bottom() - 8, 5,
                "LOW ADDRESSES", faint);
    return {segment(28, 86, "STACK", "GROWS DOWN WITH EVERY CALL", gold),
            segment(138, 170, "HEAP", "WHAT NEW TAKES AND DELETE GIVES BACK", mint),
            segment(322, 62, "STATIC", "AS LONG AS THE PROGRAM", sky_blue),
            segment(394, 62, "CODE", "WHAT THE COMPILER MADE", rose)};
}

// The stack grows down and the heap grows up, as a rule: an arrow of each in the gap between them.
inline void draw_growth(Sheet& sheet, const Box& stack) {
    const Real gap = stack.bottom() + 2;
    const Real down = stack.left + 114, up = stack.left + 126;
    sheet.arrow({down, gap}, {down, gap}, {down, gap + 8}, {down, gap + 18}, gold, 1);
    sheet.arrow({up, gap + 20}, {up, gap + 20}, {up, gap + 12}, {up, gap + 2}, mint, 1);
    sheet.words(down - 8 - Sheet::width_of("STACK", 5), gap + 8, 5, "STACK", gold);
    sheet.words(up + 8, gap + 8, 5, "HEAP", mint);
}

// The pixels themselves, small. Returns where they are drawn.
inline Box draw_pixels(Sheet& sheet, const Box& heap, const Canvas<Color>& canvas) {
    const Box pixels{heap.left + 14, heap.top + 34, 132, 132 * Real(9) / 16};
    sheet.paint(
        pixels,
        [&](Vec2 p) {
            return std::max(
                {pixels.left - p.x, p.x - pixels.right(), pixels.top - p.y, p.y - pixels.bottom()});
        },
        [&](Vec2 p) {
            const auto place = [](Real t, int count) {
                return std::clamp(static_cast<int>(t * static_cast<Real>(count)), 0, count - 1);
            };
            return canvas.at(place((p.x - pixels.left) / pixels.width, canvas.width()),
                             place((p.y - pixels.top) / pixels.height, canvas.height()));
        });
    sheet.frame(pixels, mint, Real(0.8), 1);
    sheet.words(pixels.left, pixels.bottom() + 9, 6, std::to_string(canvas.size()) + " PIXELS",
                mint);
    sheet.words(pixels.left, pixels.bottom() + 21, 6,
                std::to_string(canvas.size() * sizeof(Color)) + " BYTES", faint);
    return pixels;
}

inline Box draw_nodes(Sheet& sheet, const Box& heap, const RangeNode* root) {
    const Box tree{heap.left + 172, heap.top + 42, heap.width - 200, 88};
    draw_tree(sheet, root, tree, 4);
    sheet.words_around(
        {tree.center().x, tree.bottom() + 21}, 6,
        std::to_string(count_nodes(root)) + " NODES -- " + std::to_string(depth_of(root)) + " DEEP",
        mint);
    return tree;
}

inline Box draw_corners(Sheet& sheet, const Box& fixed, const Canvas<Color>& canvas) {
    const Box corners =
        draw_cells(sheet, fixed.left + 14, fixed.top + 25, "", {"", "", "", ""}, sky_blue);
    const int right = canvas.width() - 1, bottom = canvas.height() - 1;
    const Color colors[] = {canvas.at(0, 0), canvas.at(right, 0), canvas.at(0, bottom),
                            canvas.at(right, bottom)};
    for (int i = 0; i < 4; ++i)
        sheet.box({corners.left + 22 * static_cast<Real>(i) + 2, corners.top + 2, 18, 16},
                  colors[i], 1, 1);
    sheet.words(corners.right() + 10, corners.top + 7, 6, "FOUR CORNERS", sky_blue);
    return corners;
}

// Returns where the last one is drawn, gradient().
inline Box draw_functions(Sheet& sheet, const Box& code) {
    Box last;
    Real x = code.left + 14;
    for (const char* const name : {"MAIN", "RENDER", "GRADIENT"}) {
        last = draw_cells(sheet, x, code.top + 25, "", {name}, rose);
        x = last.right() + 12;
    }
    return last;
}

// Where each thing is drawn that a pointer starts from or leads to.
struct Places {
    Box canvas, root, paint, pixels, tree, corners, gradient;
};

inline Places draw_things(Sheet& sheet, const Segments& in, const Exhibits& show) {
    const auto on_stack = [&](Real across, const char* name,
                              const std::vector<std::string>& parts) {
        return draw_cells(sheet, in.stack.left + across, in.stack.top + 36, name, parts, gold);
    };
    return {
        on_stack(14, "CANVAS",
                 {std::to_string(show.canvas.width()), std::to_string(show.canvas.height()), ""}),
        on_stack(176, "ROOT", {""}),
        on_stack(300, "PAINT", {""}),
        draw_pixels(sheet, in.heap, show.canvas),
        draw_nodes(sheet, in.heap, show.root),
        draw_corners(sheet, in.fixed, show.canvas),
        draw_functions(sheet, in.code)};
}

// From the variables on the stack to what they point to.
inline void draw_pointers(Sheet& sheet, const Box& panel, const Places& at) {
    sheet.arrow({at.canvas.right() - 11, at.canvas.center().y},
                {at.canvas.right() - 11, at.canvas.bottom() + 40},
                {at.pixels.left + 40, at.pixels.top - 50}, {at.pixels.left + 40, at.pixels.top - 3},
                gold);
    const Real top_node = at.tree.left + at.tree.width / 2;
    sheet.arrow(at.root.center(), {at.root.center().x, at.root.bottom() + 40},
                {top_node, at.tree.top - 40}, {top_node, at.tree.top - 2}, gold);
    sheet.arrow(at.paint.center(), {panel.right() + 38, at.paint.center().y + 30},
                {panel.right() + 10, at.gradient.center().y},
                {at.gradient.right() + 3, at.gradient.center().y}, gold);
}

// As in Exhibits: six of them or none.
inline void draw_addresses(Sheet& sheet, const Places& at,
                           const std::vector<std::string>& addresses) {
    if (addresses.size() != 6) return;
    const Vec2 places[] = {
        {at.canvas.left + 40, at.canvas.top - 11},      {at.root.left + 28, at.root.top - 11},
        {at.paint.left + 34, at.paint.top - 11},        {at.pixels.left + 48, at.pixels.top - 10},
        {at.corners.right() + 100, at.corners.top + 7}, {at.gradient.left, at.gradient.top - 9}};
    for (std::size_t i = 0; i < addresses.size(); ++i)
        sheet.words(places[i].x, places[i].y, 5, addresses[i], ink);
}

inline void draw_memory(Sheet& sheet, const Box& panel, const Exhibits& show) {
    draw_panel(sheet, panel, "WHERE THINGS LIVE");
    const Segments segments = draw_segments(sheet, panel);
    draw_growth(sheet, segments.stack);
    const Places places = draw_things(sheet, segments, show);
    draw_pointers(sheet, panel, places);
    draw_addresses(sheet, places, show.addresses);
}

// Every step of the chain is an arc from one place of the memory to the next one.
inline void draw_chain(Sheet& sheet, const Box& box) {
    draw_panel(sheet, box, "ONE CHAIN IN TWO MEMORIES");
    const ScatteredChain chain{48};
    const std::vector<Link> links = gathered(chain.first());
    const Real left = box.left + 18, pitch = (box.width - 36) / 47, base = box.top + 152,
               lower = base + 30;
    const auto draw = [&](const std::vector<Link>& memory, Real line, Real sign) {
        // The places that the chain goes through, as long as it stays in this memory.
        std::vector<Real> places;
        const Link* link = memory.data();
        const std::less<const Link*> before;
        while (places.size() < memory.size() && link && !before(link, memory.data()) &&
               before(link, memory.data() + memory.size())) {
            places.push_back(left + pitch * static_cast<Real>(link - memory.data()));
            link = link->next;
        }
        const auto color = [&](std::size_t i) { return along_rainbow(static_cast<Real>(i) / 47); };
        for (std::size_t i = 1; i < places.size(); ++i) {
            const Real height = std::max<Real>(5, std::abs(places[i] - places[i - 1]) * Real(0.3));
            sheet.arc(places[i - 1], places[i], line, sign * height, color(i - 1), Real(1.2),
                      Real(0.85));
        }
        for (std::size_t i = 0; i < memory.size(); ++i)
            sheet.box(
                {left + pitch * static_cast<Real>(i) - 3, sign > 0 ? line + 2 : line - 8, 6, 6},
                faint, Real(0.5), 1);
        for (std::size_t i = 0; i < places.size(); ++i)
            sheet.box({places[i] - 3, sign > 0 ? line + 2 : line - 8, 6, 6}, color(i), 1, 1);
    };
    draw(chain.links, base, 1);
    draw(links, lower, -1);
    sheet.words(left - 4, box.top + 28, 6, "SCATTERED", ink);
    sheet.words(left - 4, lower + 14, 6, "GATHERED", ink);
}

inline void draw_steps(Sheet& sheet, const Box& box, const std::vector<Steps>& all,
                       bool by_machine) {
    draw_panel(sheet, box, by_machine ? "TIME OF A STEP HERE" : "TIME OF A STEP -- MODEL");
    const Box plot{box.left + 40, box.top + 40, box.width - 58, box.height - 74};
    const int powers = 4;  // of ten, above a tenth of a nanosecond
    const auto place = [&](double bytes, double ns) {
        const Real across = static_cast<Real>(std::log2(bytes / smallest) / 16);
        const Real up = static_cast<Real>(std::log10(ns * 10) / powers);
        return Vec2{plot.left + plot.width * across,
                    plot.bottom() - plot.height * std::clamp(up, Real(0), Real(1))};
    };
    const char* const times[] = {"0.1", "1", "10", "100", "1000"};
    for (int i = 0; i <= powers; ++i) {
        const Real y = plot.bottom() - plot.height * static_cast<Real>(i) / powers;
        sheet.line({plot.left, y}, {plot.right(), y}, ink, Real(0.7), Real(0.18));
        const std::string label = times[i];
        sheet.words(plot.left - 8 - Sheet::width_of(label, 6), y - 3, 6, label, faint);
    }
    sheet.words(plot.left - 28, plot.top - 14, 6, "NS", faint);
    const char* const sizes[] = {"1K", "16K", "256K", "4M", "64M"};
    for (int i = 0; i < 5; ++i) {
        const Real x = plot.left + plot.width * static_cast<Real>(i) / 4;
        sheet.words_around({x, plot.bottom() + 13}, 6, sizes[i], faint);
    }
    sheet.words_around({plot.left + plot.width / 2, plot.bottom() + 25}, 5, "BYTES OF THE CHAIN",
                       faint);
    if (!by_machine)
        for (const Level& level : levels) {
            if (level.bytes > largest_size) continue;
            const Real x = place(level.bytes, 1).x;
            for (Real y = plot.top; y < plot.bottom(); y += 6)
                sheet.line({x, y}, {x, y + 2}, faint, Real(0.8), Real(0.6));
            sheet.words_around({x, plot.top - 8}, 6, level.name, faint);
        }
    const auto curve = [&](double Steps::*time, Color color) {
        for (std::size_t i = 1; i < all.size(); ++i)
            sheet.line(place(all[i - 1].bytes, all[i - 1].*time), place(all[i].bytes, all[i].*time),
                       color, Real(1.8));
        for (const Steps& steps : all) sheet.dot(place(steps.bytes, steps.*time), 3, color);
    };
    curve(&Steps::gathered, mint);
    curve(&Steps::scattered, rose);
    sheet.words(plot.left + 12, plot.bottom() - 26, 6, "GATHERED", mint);
    const Vec2 middle = place(1 << 18, 1);
    // Between two lines of the grid and two levels of the caches.
    sheet.words(middle.x + 40, plot.top + plot.height * Real(0.61), 6, "SCATTERED", rose);
}

inline void draw_objects(Sheet& sheet, const Box& box, const Objects& objects, bool by_machine) {
    draw_panel(sheet, box, by_machine ? "NS AN OBJECT" : "CALLS OF NEW");
    const char* const names[] = {"STACK", "HEAP", "AT ONCE"};
    const Color colors[] = {gold, rose, mint};
    const double values[] = {by_machine ? objects.stack : 0, by_machine ? objects.heap : 1000,
                             by_machine ? objects.together : 1};
    const Real base = box.bottom() - 30, room = box.height - 84, pitch = (box.width - 30) / 3;
    const double most = *std::max_element(values, values + 3);
    for (int i = 0; i < 3; ++i) {
        const Real left = box.left + 15 + pitch * static_cast<Real>(i);
        const Real height =
            std::max<Real>(Real(1.5), room * static_cast<Real>(values[i] / std::max(most, 1e-9)));
        sheet.box({left + 8, base - height, pitch - 16, height}, colors[i], Real(0.9), 2);
        char text[16];
        std::snprintf(text, sizeof text, by_machine ? "%.1f" : "%.0f", values[i]);
        sheet.words_around({left + pitch / 2, base - height - 9}, 7, text, ink);
        sheet.words_around({left + pitch / 2, base + 12}, 6, names[i], faint);
    }
    if (!by_machine) sheet.words(box.left + 12, box.top + 26, 5, "FOR 1000 OBJECTS", faint);
}

inline Image draw_poster(Image background, const Exhibits& show) {
    Sheet sheet{std::move(background)};
    draw_memory(sheet, {24, 24, 440, 492}, show);
    draw_chain(sheet, {484, 24, 452, 232});
    draw_steps(sheet, {484, 276, 268, 240}, show.steps, show.by_machine);
    draw_objects(sheet, {772, 276, 164, 240}, show.objects, show.by_machine);
    return std::move(sheet.image);
}

}  // namespace toolchain
