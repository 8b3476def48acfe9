#pragma once
// Drawing on a picture with soft edges. Places are in units of the poster, 960 x 540 of them, which
// is scaled to the picture and stands in its middle.

#include <algorithm>
#include <app/lettering.hpp>
#include <cmath>
#include <rt/image.hpp>
#include <string_view>

namespace toolchain {

using namespace rt;

struct Box {
    Real left = 0, top = 0, width = 0, height = 0;

    Real right() const { return left + width; }
    Real bottom() const { return top + height; }
    Vec2 center() const { return {left + width / 2, top + height / 2}; }
};

class Sheet {
  public:
    explicit Sheet(Image background)
        : image{std::move(background)},
          scale_{std::min(static_cast<Real>(image.width()) / 960,
                          static_cast<Real>(image.height()) / 540)},
          origin_{(static_cast<Real>(image.width()) - 960 * scale_) / 2,
                  (static_cast<Real>(image.height()) - 540 * scale_) / 2} {}

    // Mixes in a color that depends on the place, wherever `distance` is below 0.
    template <class Distance, class Paint>
    void paint(const Box& around, Distance distance, Paint color_at, Real share = 1) {
        const auto pixel = [](Real x, int end) {
            return static_cast<int>(std::clamp(x, Real(0), static_cast<Real>(end)));
        };
        const int left = pixel(origin_.x + around.left * scale_ - 1, image.width());
        const int right = pixel(origin_.x + around.right() * scale_ + 2, image.width());
        const int top = pixel(origin_.y + around.top * scale_ - 1, image.height());
        const int bottom = pixel(origin_.y + around.bottom() * scale_ + 2, image.height());
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                const Vec2 p{(static_cast<Real>(x) + Real(0.5) - origin_.x) / scale_,
                             (static_cast<Real>(y) + Real(0.5) - origin_.y) / scale_};
                const Real cover =
                    std::clamp(Real(0.5) - distance(p) * scale_, Real(0), Real(1)) * share;
                if (cover > 0) image.at(x, y) = mix(image.at(x, y), color_at(p), cover);
            }
    }
    template <class Distance>
    void fill(const Box& around, Distance distance, Color color, Real share = 1) {
        paint(
            around, distance, [&](Vec2) { return color; }, share);
    }

    // A box with round corners.
    void box(const Box& b, Color color, Real share = 1, Real radius = 3) {
        fill(
            b, [&](Vec2 p) { return distance_to_box(p, b, radius); }, color, share);
    }
    void frame(const Box& b, Color color, Real share = 1, Real radius = 3, Real thickness = 1) {
        fill(
            {b.left - 1, b.top - 1, b.width + 2, b.height + 2},
            [&](Vec2 p) { return std::abs(distance_to_box(p, b, radius)) - thickness / 2; }, color,
            share);
    }
    void line(Vec2 a, Vec2 b, Color color, Real thickness = 1, Real share = 1) {
        fill(
            {std::min(a.x, b.x) - thickness, std::min(a.y, b.y) - thickness,
             std::abs(a.x - b.x) + 2 * thickness, std::abs(a.y - b.y) + 2 * thickness},
            [&](Vec2 p) { return app::distance_to_segment(p, a, b) - thickness / 2; }, color,
            share);
    }
    void dot(Vec2 center, Real radius, Color color, Real share = 1) {
        line(center, center, color, 2 * radius, share);
    }

    // Half an ellipse over (or, with a negative height, under) the line from a to b.
    void arc(Real from, Real to, Real base, Real height, Color color, Real thickness, Real share) {
        const Real middle = (from + to) / 2, a = std::abs(to - from) / 2, b = std::abs(height);
        const Box around{middle - a - thickness, height > 0 ? base - b - thickness : base,
                         2 * (a + thickness), b + thickness};
        fill(
            around,
            [&](Vec2 p) {
                // The distance to first order: the ellipse's equation over its slope.
                const Real x = (p.x - middle) / a, y = (p.y - base) / b;
                const Real slope = std::hypot(x / a, y / b);
                return slope > 0 ? std::abs(x * x + y * y - 1) / (2 * slope) - thickness / 2
                                 : infinity;
            },
            color, share);
    }

    // A pointer: a dot, a curve with vertical or horizontal ends, and the head of an arrow.
    void arrow(Vec2 from, Vec2 leave, Vec2 arrive, Vec2 to, Color color,
               Real thickness = Real(1.6)) {
        constexpr int pieces = 24;
        const auto at = [&](Real t) {
            const Real s = 1 - t, a = s * s * s, b = 3 * s * s * t, c = 3 * s * t * t,
                       d = t * t * t;
            return Vec2{a * from.x + b * leave.x + c * arrive.x + d * to.x,
                        a * from.y + b * leave.y + c * arrive.y + d * to.y};
        };
        const Real low_x = std::min({from.x, leave.x, arrive.x, to.x}),
                   high_x = std::max({from.x, leave.x, arrive.x, to.x}),
                   low_y = std::min({from.y, leave.y, arrive.y, to.y}),
                   high_y = std::max({from.y, leave.y, arrive.y, to.y});
        fill(
            {low_x - 2, low_y - 2, high_x - low_x + 4, high_y - low_y + 4},
            [&](Vec2 p) {
                Real nearest = infinity;
                for (int i = 0; i < pieces; ++i)
                    nearest = std::min(
                        nearest, app::distance_to_segment(p, at(static_cast<Real>(i) / pieces),
                                                          at(static_cast<Real>(i + 1) / pieces)));
                return nearest - thickness / 2;
            },
            color);
        dot(from, thickness * Real(1.5), color);
        const Vec2 back{to.x - arrive.x, to.y - arrive.y};
        const Real length = std::hypot(back.x, back.y), size = 3 * thickness;
        if (!(length > 0)) return;
        const Vec2 along{back.x / length * size, back.y / length * size};
        for (const int side : {-1, 1}) {
            const auto turn = static_cast<Real>(side) * Real(0.6);
            line(to, {to.x - along.x + turn * along.y, to.y - along.y - turn * along.x}, color,
                 thickness);
        }
    }

    // Words whose capital letters are this high; the first one's top left corner is at (x, y).
    void words(Real x, Real y, Real height, std::string_view text, Color color, Real share = 1) {
        const Real unit = height / 4;
        if (unit * scale_ < Real(0.6)) return;  // not to be read
        fill(
            {x - unit, y - unit, width_of(text, height) + 2 * unit, height + 2 * unit},
            [&](Vec2 p) {
                return unit * (app::distance_to_text({(p.x - x) / unit, (p.y - y) / unit}, text) -
                               Real(0.36));
            },
            color, share);
    }
    static Real width_of(std::string_view text, Real height) {
        return (static_cast<Real>(text.size()) * app::letter_advance - Real(1.4)) * height / 4;
    }
    void words_around(Vec2 center, Real height, std::string_view text, Color color) {
        words(center.x - width_of(text, height) / 2, center.y - height / 2, height, text, color);
    }

    Image image;

  private:
    static Real distance_to_box(Vec2 p, const Box& b, Real radius) {
        radius = std::min({radius, b.width / 2, b.height / 2});
        const Vec2 c = b.center();
        const Real x = std::abs(p.x - c.x) - b.width / 2 + radius,
                   y = std::abs(p.y - c.y) - b.height / 2 + radius;
        return std::hypot(std::max(x, Real(0)), std::max(y, Real(0))) +
               std::min(std::max(x, y), Real(0)) - radius;
    }

    Real scale_;
    Vec2 origin_;
};

}  // namespace toolchain
