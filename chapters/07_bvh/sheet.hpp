#pragma once
// The sheet that the panels are on: lines, words, and the scale of the heat maps.

#include <app/lettering.hpp>
#include <rt/box.hpp>
#include <rt/camera.hpp>
#include <rt/dot.hpp>
#include <rt/image.hpp>
#include <string_view>

namespace bvh {

using namespace rt;

inline const Color paper = from_hex(0x12141c), ink = from_hex(0xe8e4da);

// A part of the sheet, in pixels.
struct Panel {
    int left = 0, top = 0, width = 1, height = 1;
};

inline Panel inset(const Panel& p, int by) {
    return {p.left + by, p.top + by, p.width - 2 * by, p.height - 2 * by};
}

// Mixes a color into a pixel, if it is one of the image's.
inline void blend(Image& image, int x, int y, Color color, Real share) {
    if (x < 0 || y < 0 || x >= image.width() || y >= image.height()) return;
    image.at(x, y) = mix(image.at(x, y), color, std::clamp(share, Real(0), Real(1)));
}

// A word with letters `size` pixels high, its top left corner at (left, top).
inline void write(Image& image, std::string_view word, Real left, Real top, Real size,
                  Color color = ink) {
    const Real unit = size / 4, reach = app::letter_advance * static_cast<Real>(word.size());
    const Real stroke = std::max(Real(0.6), unit / 3);
    const auto pixel = [](Real x) { return static_cast<int>(std::floor(x)); };
    for (int y = pixel(top - unit); y <= pixel(top + size + unit); ++y)
        for (int x = pixel(left - unit); x <= pixel(left + reach * unit); ++x) {
            const Vec2 at{(static_cast<Real>(x) + Real(0.5) - left) / unit,
                          (static_cast<Real>(y) + Real(0.5) - top) / unit};
            blend(image, x, y, color, stroke + Real(0.5) - unit * app::distance_to_text(at, word));
        }
}

// The same on a dark plate: to be read on any ground.
inline void write_on_plate(Image& image, std::string_view word, Real left, Real top, Real size) {
    const Real margin = size / 2, unit = size / 4;
    const Real wide = app::letter_advance * static_cast<Real>(word.size()) * unit;
    const auto edge = [](Real x) { return static_cast<int>(std::lround(x)); };
    for (int y = edge(top - margin); y < edge(top + size + margin); ++y)
        for (int x = edge(left - margin); x < edge(left + wide + margin); ++x)
            blend(image, x, y, paper, 1);
    write(image, word, left, top, size);
}

// From black over violet and orange to white, as x goes from 0 to 1: twice as light, twice as much.
inline Color heat_color(Real x) {
    static const Color steps[] = {from_hex(0x07071a), from_hex(0x2b1055), from_hex(0x7b1fa2),
                                  from_hex(0xd6336c), from_hex(0xff7b39), from_hex(0xffd166),
                                  from_hex(0xfffbe6)};
    const Real place = std::clamp(x, Real(0), Real(1)) * 6;
    const int step = std::min(5, static_cast<int>(place));
    return mix(steps[step], steps[step + 1], place - static_cast<Real>(step));
}

// 1 test is 0, 10,000 tests are 1; each tenfold is a quarter.
inline Real heat(Real tests) {
    return std::log10(std::max(Real(1), tests)) / 4;
}

// Where a point is seen, in pixels.
inline Vec2 project(const Camera& camera, Vec3 point) {
    const Vec3 to = point - camera.eye;
    const Real depth = -dot(to, camera.basis.w);
    const Real x = dot(to, camera.basis.u) / depth / camera.viewport.width + Real(0.5);
    const Real y = Real(0.5) - dot(to, camera.basis.v) / depth / camera.viewport.height;
    return {x * static_cast<Real>(camera.width), y * static_cast<Real>(camera.height)};
}

// A smooth line, one pixel wide.
inline void draw_line(Image& image, const Panel& panel, Vec2 a, Vec2 b, Color color, Real share) {
    const Real length = std::hypot(b.x - a.x, b.y - a.y);
    // The box of a scene fits into the picture; what does not is left out.
    if (!(length < 8 * static_cast<Real>(panel.width + panel.height))) return;
    const int steps = 1 + static_cast<int>(length * 2);
    for (int i = 0; i < steps; ++i) {
        const Real t = (static_cast<Real>(i) + Real(0.5)) / static_cast<Real>(steps);
        const Real x = a.x + t * (b.x - a.x) - Real(0.5), y = a.y + t * (b.y - a.y) - Real(0.5);
        const Real column = std::floor(x), row = std::floor(y);
        for (int k = 0; k < 4; ++k) {
            const int px = static_cast<int>(column) + k % 2, py = static_cast<int>(row) + k / 2;
            if (px < 0 || py < 0 || px >= panel.width || py >= panel.height) continue;
            const Real wx = k % 2 ? x - column : 1 - (x - column);
            const Real wy = k / 2 ? y - row : 1 - (y - row);
            blend(image, panel.left + px, panel.top + py, color, share * wx * wy);
        }
    }
}

// The twelve edges of a box.
inline void draw_box(Image& image, const Panel& panel, const Camera& camera, const Box& box,
                     Color color, Real share) {
    const auto corner = [&](int i) {
        return project(camera, {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                                i & 4 ? box.high.z : box.low.z});
    };
    for (int i = 0; i < 8; ++i)
        for (const int bit : {1, 2, 4})
            if (!(i & bit)) draw_line(image, panel, corner(i), corner(i | bit), color, share);
}

}  // namespace bvh
