#pragma once
// Drawing on a picture: boxes, lines and words.

#include <algorithm>
#include <app/lettering.hpp>
#include <cmath>
#include <rt/image.hpp>
#include <string_view>

namespace threads {

using namespace rt;

// In pixels; the picture may be too small for it.
struct Box {
    Real left = 0, top = 0, width = 0, height = 0;
};

class Sheet {
  public:
    Sheet(int width, int height, Color background) : image{width, height, background} {}

    // Paints the pixels whose middle lies within the box: paint(column, row) gives their colors,
    // counted from the box's first pixel.
    template <class Paint>
    void paint(const Box& box, Paint color_at) {
        const int left = first(box.left),
                  right = std::min(first(box.left + box.width), image.width());
        const int top = first(box.top),
                  bottom = std::min(first(box.top + box.height), image.height());
        for (int y = std::max(0, top); y < bottom; ++y)
            for (int x = std::max(0, left); x < right; ++x)
                image.at(x, y) = color_at(x - left, y - top);
    }
    void fill(const Box& box, Color color) {
        paint(box, [&](int, int) { return color; });
    }

    // Mixes the color in where `distance(p)` is below half the thickness, with a soft edge.
    template <class Distance>
    void stroke(const Box& box, Real thickness, Color color, Distance distance) {
        const int left = std::max(0, first(box.left)), top = std::max(0, first(box.top));
        const int right = std::min(first(box.left + box.width), image.width());
        const int bottom = std::min(first(box.top + box.height), image.height());
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                const Vec2 p{static_cast<Real>(x) + Real(0.5), static_cast<Real>(y) + Real(0.5)};
                const Real cover =
                    std::clamp(thickness / 2 + Real(0.5) - distance(p), Real(0), Real(1));
                if (cover > 0) image.at(x, y) = mix(image.at(x, y), color, cover);
            }
    }
    void line(Vec2 a, Vec2 b, Real thickness, Color color) {
        const Box box{std::min(a.x, b.x) - thickness, std::min(a.y, b.y) - thickness,
                      std::abs(a.x - b.x) + 2 * thickness, std::abs(a.y - b.y) + 2 * thickness};
        stroke(box, thickness, color, [&](Vec2 p) { return app::distance_to_segment(p, a, b); });
    }
    void dot(Vec2 center, Real radius, Color color) { line(center, center, 2 * radius, color); }

    // Words whose capital letters are this high; the first one's top left corner is at (x, y).
    void words(Real x, Real y, Real height, std::string_view text, Color color) {
        const Real unit = height / 4;
        if (unit < Real(0.75)) return;  // not to be read
        const Box box{x - unit, y - unit, width_of(text, height) + 2 * unit, height + 2 * unit};
        stroke(box, unit * Real(0.72), color, [&](Vec2 p) {
            return unit * app::distance_to_text({(p.x - x) / unit, (p.y - y) / unit}, text);
        });
    }
    static Real width_of(std::string_view text, Real height) {
        return static_cast<Real>(text.size()) * app::letter_advance * height / 4;
    }

    Image image;

  private:
    static int first(Real edge) { return static_cast<int>(std::ceil(edge - Real(0.5))); }
};

}  // namespace threads
