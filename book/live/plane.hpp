#pragma once
// What figures of a plane have in common: its points in space, a grid, vectors with names, angles.

#include <array>
#include <cmath>
#include <cstddef>
#include <rt/vec3.hpp>
#include <string_view>
#include <vector>

#include "live.hpp"

namespace live {

// The figures' plane is z = 0.
inline Point in_plane(rt::Vec3 v) {
    return {v.x, v.y};
}

inline double in_degrees(double radians) {
    return radians / rt::radians(1);
}

// Lines at all whole numbers, those through zero darker.
inline void draw_grid(Drawing& out, const Frame& frame) {
    const Point low = frame.to_plane({0, out.height}), high = frame.to_plane({out.width, 0});
    for (double x = std::ceil(low.x); x <= high.x; ++x)
        out.line(frame.to_page({x, low.y}), frame.to_page({x, high.y}),
                 {x == 0 ? muted : faint, x == 0 ? 1.2 : 0.8});
    for (double y = std::ceil(low.y); y <= high.y; ++y)
        out.line(frame.to_page({low.x, y}), frame.to_page({high.x, y}),
                 {y == 0 ? muted : faint, y == 0 ? 1.2 : 0.8});
}

// An arrow with its name beyond the tip.
inline void draw_vector(Drawing& out, Point from, Point to, std::string_view name, Ink color) {
    out.arrow(from, to, {color, 3});
    const double length = distance(from, to);
    out.bold = true;
    if (length > 0) out.text(to + (22 / length) * (to - from), name, color);
    out.bold = false;
}

// The handle that is nearest to where the pointer went down.
template <std::size_t Count>
std::size_t nearest_of(const std::array<Point, Count>& places, Point down) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < Count; ++i)
        if (distance(places[i], down) < distance(places[nearest], down)) nearest = i;
    return nearest;
}

// Part of a circle around a point of the page, from one angle to another, in radians,
// counterclockwise if the second is larger.
inline void draw_arc(Drawing& out, Point center, double radius, double from, double to, Pen pen) {
    std::vector<Point> points;
    const int count = 3 + static_cast<int>(std::abs(to - from) * 12);
    for (int i = 0; i <= count; ++i) {
        const double angle = from + (to - from) * i / count;
        points.push_back(center + radius * Point{std::cos(angle), -std::sin(angle)});
    }
    out.path(points, pen);
}

}  // namespace live
