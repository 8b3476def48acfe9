#pragma once
// The panel that shows what is on the stack, on the heap, in static memory and in the code.

#include <rt/binary_tree.hpp>
#include <rt/canvas.hpp>
#include <rt/range_node.hpp>
#include <string>
#include <vector>

#include "panel.hpp"

namespace toolchain {

// Draws a variable: its name above, and a cell for each of its parts.
inline app::Box draw_cells(Figure& figure, Real left, Real top, std::string_view name,
                           const std::vector<std::string>& parts, Color color) {
    figure.words({left, top}, name, {6, color});
    Real x = left;
    for (const std::string& part : parts) {
        const Real width = std::max<Real>(22, app::width_of(part, 6) + 10);
        figure.box({x, top + 11, width, 20}, color, Real(0.16), 2);
        figure.frame({x, top + 11, width, 20}, color, Real(0.8), 2);
        figure.words_around({x + width / 2, top + 21}, part, {6, ink});
        x += width;
    }
    return {left, top + 11, x - left, 20};
}

// Draws the nodes of a tree, level by level, with an arrow for each unique_ptr.
inline void draw_tree(Figure& figure, const RangeNode* node, const app::Box& box, int rows) {
    if (!node || rows <= 0) return;
    const Vec2 here{box.left + box.width / 2, box.top + 6};
    const Real step = (box.height - 12) / static_cast<Real>(std::max(1, rows - 1));
    const auto child = [&](const std::unique_ptr<RangeNode>& owner, Real left, Real width) {
        if (!owner || rows <= 1) return;
        const app::Box below{left, box.top + step, width, box.height - step};
        const Vec2 to{below.left + below.width / 2, below.top};
        figure.arrow({here.x, here.y + 3}, {here.x, here.y + step / 2}, {to.x, to.y - step / 2}, to,
                     mint, 1);
        draw_tree(figure, owner.get(), below, rows - 1);
    };
    const int count = node->last - node->first;
    const int left_count = node->left ? node->left->last - node->left->first : count / 2;
    const Real share = static_cast<Real>(left_count) / static_cast<Real>(std::max(1, count));
    child(node->left, box.left, box.width * share);
    child(node->right, box.left + box.width * share, box.width * (1 - share));
    const app::Box cell{here.x - 7, here.y - 6, 14, 12};
    figure.box(cell, glass, 1, 2);
    figure.box(cell, mint, node->left ? Real(0.35) : Real(0.85), 2);
    figure.words_around(here, std::to_string(count), {Real(6.5), node->left ? ink : glass});
}

// The four parts of memory, each with its own area in the panel.
struct Segments {
    app::Box stack, heap, fixed, code;
};

inline Segments draw_segments(Figure& figure, const app::Box& panel) {
    const auto segment = [&](Real top, Real height, std::string_view name, std::string_view what,
                             Color color) {
        const app::Box b{panel.left + 12, panel.top + top, panel.width - 24, height};
        figure.box(b, color, Real(0.10), 4);
        figure.box({b.left, b.top, 3, b.height}, color, 1, 1);
        figure.words({b.left + 12, b.top + 9}, name, {8, color});
        // The words stand beside the name. In the heap's area, which is the tallest, they stand at
        // the bottom, because an arrow comes down beside the name.
        if (height < 100)
            figure.words({b.left + 12 + app::width_of(name, 8) + 12, b.top + 11}, what, {6, faint});
        else
            figure.words({b.left + 14, b.bottom() - 13}, what, {6, faint});
        return b;
    };
    figure.words_before({panel.right() - 12, panel.top + 13}, "High addresses", {6, faint});
    figure.words_before({panel.right() - 12, panel.bottom() - 16}, "Low addresses", {6, faint});
    return {segment(28, 86, "Stack", "grows down with every call", gold),
            segment(138, 170, "Heap", "what new takes and delete gives back", mint),
            segment(322, 62, "Static", "as long as the program", sky_blue),
            segment(394, 62, "Code", "what the compiler made", rose)};
}

// Draws two arrows between stack and heap: as a rule, the stack grows down and the heap grows up.
inline void draw_growth(Figure& figure, const app::Box& stack) {
    const Real gap = stack.bottom() + 2;
    const Real down = stack.left + 114, up = stack.left + 126;
    figure.arrow({down, gap}, {down, gap}, {down, gap + 8}, {down, gap + 18}, gold, 1);
    figure.arrow({up, gap + 20}, {up, gap + 20}, {up, gap + 12}, {up, gap + 2}, mint, 1);
    figure.words_before({down - 8, gap + 8}, "Stack", {6, gold});
    figure.words({up + 8, gap + 8}, "Heap", {6, mint});
}

// Draws the canvas's pixels as a small picture, and returns the box around it.
inline app::Box draw_pixels(Figure& figure, const app::Box& heap, const Canvas<Color>& canvas) {
    const app::Box pixels{heap.left + 14, heap.top + 34, 132, 132 * Real(9) / 16};
    figure.paint(
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
    figure.frame(pixels, mint, Real(0.8), 1);
    figure.words({pixels.left, pixels.bottom() + 9}, std::to_string(canvas.size()) + " pixels",
                 {6, mint});
    figure.words({pixels.left, pixels.bottom() + 21},
                 std::to_string(canvas.size() * sizeof(Color)) + " bytes", {6, faint});
    return pixels;
}

inline app::Box draw_nodes(Figure& figure, const app::Box& heap, const RangeNode* root) {
    const app::Box tree{heap.left + 172, heap.top + 42, heap.width - 200, 88};
    draw_tree(figure, root, tree, 4);
    figure.words_around(
        {tree.center().x, tree.bottom() + 21},
        std::to_string(count_nodes(root)) + " nodes -- " + std::to_string(depth_of(root)) + " deep",
        {6, mint});
    return tree;
}

inline app::Box draw_corners(Figure& figure, const app::Box& fixed, const Canvas<Color>& canvas) {
    const app::Box corners =
        draw_cells(figure, fixed.left + 14, fixed.top + 25, "", {"", "", "", ""}, sky_blue);
    const int right = canvas.width() - 1, bottom = canvas.height() - 1;
    const Color colors[] = {canvas.at(0, 0), canvas.at(right, 0), canvas.at(0, bottom),
                            canvas.at(right, bottom)};
    for (int i = 0; i < 4; ++i)
        figure.box({corners.left + 22 * static_cast<Real>(i) + 2, corners.top + 2, 18, 16},
                   colors[i], 1, 1);
    figure.words({corners.right() + 10, corners.top + 7}, "Four corners", {6, sky_blue});
    return corners;
}

// Draws the functions, and returns the box of the last one, gradient().
inline app::Box draw_functions(Figure& figure, const app::Box& code) {
    app::Box last;
    Real x = code.left + 14;
    for (const char* const name : {"main", "render", "gradient"}) {
        last = draw_cells(figure, x, code.top + 25, "", {name}, rose);
        x = last.right() + 12;
    }
    return last;
}

// Where the things are drawn that pointers start from or lead to.
struct Places {
    app::Box canvas, root, paint, pixels, tree, corners, gradient;
};

inline Places draw_things(Figure& figure, const Segments& in, const Canvas<Color>& canvas,
                          const RangeNode* root) {
    const auto on_stack = [&](Real across, const char* name,
                              const std::vector<std::string>& parts) {
        return draw_cells(figure, in.stack.left + across, in.stack.top + 36, name, parts, gold);
    };
    return {on_stack(14, "canvas",
                     {std::to_string(canvas.width()), std::to_string(canvas.height()), ""}),
            on_stack(176, "root", {""}),
            on_stack(300, "paint", {""}),
            draw_pixels(figure, in.heap, canvas),
            draw_nodes(figure, in.heap, root),
            draw_corners(figure, in.fixed, canvas),
            draw_functions(figure, in.code)};
}

// Draws the arrows from the variables on the stack to what they point to.
inline void draw_pointers(Figure& figure, const app::Box& panel, const Places& at) {
    figure.arrow({at.canvas.right() - 11, at.canvas.center().y},
                 {at.canvas.right() - 11, at.canvas.bottom() + 40},
                 {at.pixels.left + 40, at.pixels.top - 50},
                 {at.pixels.left + 40, at.pixels.top - 3}, gold);
    const Real top_node = at.tree.left + at.tree.width / 2;
    figure.arrow(at.root.center(), {at.root.center().x, at.root.bottom() + 40},
                 {top_node, at.tree.top - 40}, {top_node, at.tree.top - 2}, gold);
    figure.arrow(at.paint.center(), {panel.right() + 38, at.paint.center().y + 30},
                 {panel.right() + 10, at.gradient.center().y},
                 {at.gradient.right() + 3, at.gradient.center().y}, gold);
}

// Writes the addresses of canvas, root, paint, pixels, corners and gradient, if all six are given.
inline void draw_addresses(Figure& figure, const Places& at,
                           const std::vector<std::string>& addresses) {
    if (addresses.size() != 6) return;
    const Vec2 places[] = {
        {at.canvas.left + 40, at.canvas.top - 11},      {at.root.left + 28, at.root.top - 11},
        {at.paint.left + 34, at.paint.top - 11},        {at.pixels.left + 48, at.pixels.top - 10},
        {at.corners.right() + 100, at.corners.top + 7}, {at.gradient.left, at.gradient.top - 9}};
    for (std::size_t i = 0; i < addresses.size(); ++i)
        figure.words({places[i].x, places[i].y}, addresses[i], {5, ink});
}

inline void draw_memory(Figure& figure, const app::Box& panel, const Canvas<Color>& canvas,
                        const RangeNode* root, const std::vector<std::string>& addresses) {
    draw_panel(figure, panel, "Where things live");
    const Segments segments = draw_segments(figure, panel);
    draw_growth(figure, segments.stack);
    const Places places = draw_things(figure, segments, canvas, root);
    draw_pointers(figure, panel, places);
    draw_addresses(figure, places, addresses);
}

}  // namespace toolchain
