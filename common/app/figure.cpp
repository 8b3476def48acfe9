#include <app/figure.hpp>
#include <app/run.hpp>
#include <rt/portable.hpp>

namespace app {

using rt::Color, rt::Image, rt::Real, rt::Vec2;

namespace {

// The first pixel whose middle lies on the edge or beyond it.
int first_pixel(Real edge) {
    return static_cast<int>(std::ceil(edge - Real(0.5)));
}

// The distance from p to a box with round corners; it is below 0 if p lies within the box.
Real distance_to_box(Vec2 p, const Box& b, Real radius) {
    radius = std::min({radius, b.width / 2, b.height / 2});
    const Vec2 c = b.center();
    const Real x = std::abs(p.x - c.x) - b.width / 2 + radius,
               y = std::abs(p.y - c.y) - b.height / 2 + radius;
    return rt::portable::hypot(std::max(x, Real(0)), std::max(y, Real(0))) +
           std::min(std::max(x, y), Real(0)) - radius;
}

// The box around all of these points, with a margin.
Box box_around(std::initializer_list<Vec2> points, Real margin) {
    Vec2 low{rt::infinity, rt::infinity}, high{-rt::infinity, -rt::infinity};
    for (const Vec2 p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return {low.x - margin, low.y - margin, high.x - low.x + 2 * margin,
            high.y - low.y + 2 * margin};
}

auto always(Color color) {
    return [color](Vec2) { return color; };
}

}  // namespace

Box pixel_box(int left, int top, int width, int height) {
    return {static_cast<Real>(left), static_cast<Real>(top), static_cast<Real>(width),
            static_cast<Real>(height)};
}

Real width_of(std::string_view text, Real letter_height) {
    return width_of(text) * letter_height / 4;
}

Color average_of_nine(int column, int row, const std::function<Color(Real x, Real y)>& shade) {
    const auto third = [](int pixel, int part) {
        return static_cast<Real>(pixel) + (static_cast<Real>(part) + Real(0.5)) / 3;
    };
    Color sum;
    for (int i = 0; i < 9; ++i) sum += shade(third(column, i % 3), third(row, i / 3));
    return sum / 9;
}

Figure::Figure(Image& image) : image_{&image}, columns_{image.width()}, rows_{image.height()} {}

Figure::Figure(Image& image, Real width, Real height) : Figure{image} {
    const Real across = static_cast<Real>(image.width()), down = static_cast<Real>(image.height());
    scale_ = std::min(across / width, down / height);
    origin_ = {(across - width * scale_) / 2, (down - height * scale_) / 2};
}

Figure Figure::part(const Box& box) const {
    Figure part = *this;
    part.origin_ = {origin_.x + box.left * scale_, origin_.y + box.top * scale_};
    part.left_ = first_pixel(part.origin_.x);
    part.top_ = first_pixel(part.origin_.y);
    part.columns_ = first_pixel(part.origin_.x + box.width * scale_) - part.left_;
    part.rows_ = first_pixel(part.origin_.y + box.height * scale_) - part.top_;
    return part;
}

void Figure::fill(const std::function<Color(int column, int row)>& shade, Progress* progress) {
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column) set(column, row, shade(column, row));
        if (progress) progress->step();
    }
}

void Figure::blend(const Box& around, const std::function<Real(Vec2)>& share_at,
                   const std::function<Color(Vec2)>& color_at) {
    const auto pixel = [](Real x, int begin, int end) {
        return static_cast<int>(
            std::clamp(std::floor(x), static_cast<Real>(begin), static_cast<Real>(end)));
    };
    const int end_x = std::max(left_, std::min(left_ + columns_, image_->width())),
              end_y = std::max(top_, std::min(top_ + rows_, image_->height()));
    const int left = pixel(origin_.x + around.left * scale_ - 1, left_, end_x),
              right = pixel(origin_.x + around.right() * scale_ + 2, left_, end_x),
              top = pixel(origin_.y + around.top * scale_ - 1, top_, end_y),
              bottom = pixel(origin_.y + around.bottom() * scale_ + 2, top_, end_y);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            const Vec2 p{(static_cast<Real>(x) + Real(0.5) - origin_.x) / scale_,
                         (static_cast<Real>(y) + Real(0.5) - origin_.y) / scale_};
            const Real share = share_at(p);
            if (share > 0) image_->at(x, y) = mix(image_->at(x, y), color_at(p), share);
        }
}

void Figure::paint(const Box& around, const std::function<Real(Vec2)>& distance,
                   const std::function<Color(Vec2)>& color_at, Real share) {
    blend(
        around,
        [&](Vec2 p) {
            return std::clamp(Real(0.5) - distance(p) * scale_, Real(0), Real(1)) * share;
        },
        color_at);
}

void Figure::box(const Box& box, Color color, Real share, Real radius) {
    paint(
        box, [&](Vec2 p) { return distance_to_box(p, box, radius); }, always(color), share);
}

void Figure::frame(const Box& box, Color color, Real share, Real radius, Real thickness) {
    paint(
        {box.left - thickness, box.top - thickness, box.width + 2 * thickness,
         box.height + 2 * thickness},
        [&](Vec2 p) { return std::abs(distance_to_box(p, box, radius)) - thickness / 2; },
        always(color), share);
}

void Figure::line(Vec2 a, Vec2 b, Color color, Real thickness, Real share) {
    paint(
        box_around({a, b}, thickness),
        [&](Vec2 p) { return distance_to_segment(p, a, b) - thickness / 2; }, always(color), share);
}

void Figure::dot(Vec2 center, Real radius, Color color, Real share) {
    line(center, center, color, 2 * radius, share);
}

void Figure::arrow(Vec2 from, Vec2 leave, Vec2 arrive, Vec2 to, Color color, Real thickness) {
    constexpr int pieces = 48;
    const auto at = [&](Real t) {
        const Real s = 1 - t, a = s * s * s, b = 3 * s * s * t, c = 3 * s * t * t, d = t * t * t;
        return Vec2{a * from.x + b * leave.x + c * arrive.x + d * to.x,
                    a * from.y + b * leave.y + c * arrive.y + d * to.y};
    };
    paint(
        box_around({from, leave, arrive, to}, 2),
        [&](Vec2 p) {
            Real nearest = rt::infinity;
            for (int i = 0; i < pieces; ++i)
                nearest =
                    std::min(nearest, distance_to_segment(p, at(static_cast<Real>(i) / pieces),
                                                          at(static_cast<Real>(i + 1) / pieces)));
            return nearest - thickness / 2;
        },
        always(color));
    dot(from, thickness * Real(1.5), color);
    const Vec2 back{to.x - arrive.x, to.y - arrive.y};
    const Real length = rt::portable::hypot(back.x, back.y), size = 3 * thickness;
    if (!(length > 0)) return;
    const Vec2 along{back.x / length * size, back.y / length * size};
    for (const int side : {-1, 1}) {
        const auto turn = static_cast<Real>(side) * Real(0.6);
        line(to, {to.x - along.x + turn * along.y, to.y - along.y - turn * along.x}, color,
             thickness);
    }
}

void Figure::words(Vec2 top_left, std::string_view text, const Lettering& letters) {
    const Real unit = letters.height / 4;  // of the letters' grid
    if (unit * scale_ < Real(0.75)) return;
    paint(
        {top_left.x - unit, top_left.y - unit, width_of(text, letters.height) + 2 * unit,
         letters.height + (descent + 2) * unit},
        [&](Vec2 p) {
            const Vec2 on_grid{(p.x - top_left.x) / unit, (p.y - top_left.y) / unit};
            return unit * (distance_to_text(on_grid, text) - letters.weight);
        },
        always(letters.color));
}

void Figure::words_before(Vec2 top_right, std::string_view text, const Lettering& letters) {
    words({top_right.x - width_of(text, letters.height), top_right.y}, text, letters);
}

void Figure::words_around(Vec2 middle, std::string_view text, const Lettering& letters) {
    words({middle.x - width_of(text, letters.height) / 2, middle.y - letters.height / 2}, text,
          letters);
}

}  // namespace app
