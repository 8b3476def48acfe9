#pragma once
// The tools for the live figures of the web book.
//
// To add one, say "pencil" in chapter 03:
//
// 1. Describe it in 03.json: what it shows (for people who cannot see it), what to try, and its
//    controls. A control has a name, a label and a value. A slider has min, max and step, and may
//    have a unit, "log": true (the figure gets the exponent of ten) and "play": steps per second (a
//    button moves it on). A control of "kind": "choice" has "options" instead; the figure gets the
//    number of the chosen one. A control of "kind": "turns" has two "options", each a button that
//    adds a turn, and the value 1; the figure gets a number whose binary digits after the first 1
//    are the turns. The build makes a struct of the controls: live::PencilControls.
// 2. Draw it in 03.cpp, in the namespace live: void draw(const PencilControls&, Drawing&). Lengths
//    are pixels of the page, y downward; the drawing is out.width wide, and draw() says how high.
//    Colors have names, so that they fit a dark page. All mathematics of rays comes from <rt/...>.
// 3. If it can be dragged, void drag(PencilControls&, const Drag&) changes the controls; they come
//    with the values that they had when the pointer went down. draw() marks what can be dragged
//    with handle().
// 4. For a picture that gets better while you wait, call out.refine(): see refine.hpp.
// 5. Mark where it goes in docs/03-sphere.md, below a picture, in a paragraph of its own:
//    <!-- live: 03.pencil --> puts the figure in the picture's place, <!-- live: 03.pencil below
//    --> puts it below, after the picture's caption. In print, and without scripts, only the
//    picture is there.
//
// Figures are built in double. Code that needs float goes in 03.float.cpp, which is compiled with
// Real = float and the namespace rt named rt_float: see there.
//
// node book/live/still.mjs 03.pencil > docs/images/03-pencil.svg makes the still picture, if there
// is none.
//
// node book/live/try.mjs 03.pencil shoot.png [--dark] [--width 390] [name=value ...] compiles,
// draws and photographs one figure.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <rt/color.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace live {

// A position or an offset in the drawing, or in the plane that a Frame shows.
struct Point {
    double x = 0, y = 0;

    friend constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
};

inline double distance(Point a, Point b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

// Part of a plane (x to the right, y up) and where it is in the drawing: the point `middle` of the
// plane is at `at`, and a unit is `scale` pixels long.
struct Frame {
    Point at, middle;
    double scale = 1;

    Point to_page(Point p) const {
        return {at.x + scale * (p.x - middle.x), at.y - scale * (p.y - middle.y)};
    }
    Point to_plane(Point p) const {
        return {middle.x + (p.x - at.x) / scale, middle.y - (p.y - at.y) / scale};
    }
};

// A color: one of the page's, or one of its own.
struct Ink {
    double code = 1, alpha = 1;
};
inline constexpr Ink paper{0}, ink{1}, muted{2}, faint{3}, accent{4}, blue{5}, orange{6}, green{7},
    pink{8}, amber{9}, sky{10}, gray{11}, panel{12};
constexpr Ink thin(Ink color, double alpha) {
    return {color.code, color.alpha * alpha};
}
constexpr Ink rgb(std::uint32_t rrggbb) {
    return {256 + static_cast<double>(rrggbb)};
}
inline Ink shown(rt::Color light) {
    return rgb(static_cast<std::uint32_t>(rt::to_byte(light.r) << 16 | rt::to_byte(light.g) << 8 |
                                          rt::to_byte(light.b)));
}

struct Pen {
    Ink ink = live::ink;
    double width = 2;
    double dash = 0;  // length of the dashes; 0 for none
};

enum class Align { left, middle, right };

// Where a pointer went down, and where it is now. `width` is that of the drawing.
struct Drag {
    Point down, at;
    double width = 0;

    Point moved() const { return at - down; }
};

// The pixels of a picture, as the page takes them.
struct Bytes {
    int columns = 0, rows = 0;
    std::vector<std::uint8_t> rgba;

    Bytes(int c, int r) : columns{c}, rows{r}, rgba(static_cast<std::size_t>(4 * c * r), 255) {}
    void set(int column, int row, rt::Color light) {
        std::uint8_t* p = &rgba[static_cast<std::size_t>(4 * (row * columns + column))];
        p[0] = byte(light.r), p[1] = byte(light.g), p[2] = byte(light.b);
    }

  private:
    // rt::to_byte from a table, because a picture that gets better needs it a million times a
    // second. In the darkest shades it may be off by 1.
    static std::uint8_t byte(double linear) {
        static const std::vector<std::uint8_t> table = [] {
            std::vector<std::uint8_t> bytes(8193);
            for (std::size_t i = 0; i < bytes.size(); ++i)
                bytes[i] = rt::to_byte(static_cast<rt::Real>(i) / 8192);
            return bytes;
        }();
        return table[static_cast<std::size_t>(std::clamp(linear, 0.0, 1.0) * 8192 + 0.5)];
    }
};

class Refinement;

// What a figure shows: a list of strokes that the page draws, so that they are sharp on any screen.
// In texts, {} is the next number, rounded to four digits; {.2} is one with two decimals; {e} is
// one like 1.2·10⁻⁷; {+} is one with its sign.
class Drawing {
  public:
    double width = 640;      // pixels of the page; given
    double height = 360;     // set by draw()
    double pixel_ratio = 1;  // the screen's pixels in a pixel of the page; given

    bool is_narrow() const { return width < 520; }

    void path(std::span<const Point> points, Pen pen = {}) {
        begin(Op::path, pen.ink, {pen.width, pen.dash});
        add(points);
    }
    void line(Point from, Point to, Pen pen = {}) { path({{from, to}}, pen); }
    void path(std::initializer_list<Point> points, Pen pen = {}) {
        path(std::span{points.begin(), points.size()}, pen);
    }
    void polygon(std::span<const Point> points, Ink fill) {
        begin(Op::polygon, fill, {});
        add(points);
    }
    void polygon(std::initializer_list<Point> points, Ink fill) {
        polygon(std::span{points.begin(), points.size()}, fill);
    }
    void box(Point corner, Point opposite, Ink fill) {
        polygon({corner, {opposite.x, corner.y}, opposite, {corner.x, opposite.y}}, fill);
    }
    void frame(Point corner, Point opposite, Pen pen = {}) {
        path({corner, {opposite.x, corner.y}, opposite, {corner.x, opposite.y}, corner}, pen);
    }
    void disc(Point center, double radius, Ink fill) {
        begin(Op::disc, fill, {center.x, center.y, radius});
    }
    void circle(Point center, double radius, Pen pen = {}) {
        begin(Op::circle, pen.ink, {pen.width, pen.dash, center.x, center.y, radius});
    }
    // A dot with a rim of paper, which sets it off from the lines below it.
    void dot(Point at, Ink fill, double radius = 5) {
        disc(at, radius + 1.5, paper);
        disc(at, radius, fill);
    }
    void arrow(Point from, Point to, Pen pen = {}) {
        const double length = distance(from, to);
        if (!(length > 0)) return;
        const Point along = (1 / length) * (to - from), across{-along.y, along.x};
        const double head = std::min(length, 5 + 3 * pen.width), half = 0.42 * head;
        const Point neck = to - head * along;
        line(from, neck + 1 * along, pen);
        polygon({to, neck + half * across, neck - half * across}, pen.ink);
    }
    template <class... Numbers>
    void text(Point at, std::string_view words, Ink color, Align align, Numbers... numbers) {
        begin(Op::text, color,
              {at.x, at.y, static_cast<double>(align), text_size,
               code   ? 2.0
               : bold ? 1.0
                      : 0.0,
               on_picture ? 1.0 : 0.0, keep(words), static_cast<double>(numbers)...});
    }
    void text(Point at, std::string_view words, Ink color = live::ink,
              Align align = Align::middle) {
        text<>(at, words, color, align);
    }
    double text_size = 13;
    bool bold = false;
    bool code = false;        // letters of one width, as in a program
    bool on_picture = false;  // white with a dark rim

    // A disk that can be dragged. With grip, a ring shows it.
    void handle(Point at, double radius = 16, bool grip = true) {
        if (grip) {
            disc(at, 9, thin(accent, 0.25));
            circle(at, 9, {accent, 1.5});
        }
        begin(Op::handle, ink, {at.x, at.y, radius});
    }
    // The whole drawing can be dragged; a touch that moves up or down scrolls the page, though.
    void handle_everywhere() { begin(Op::handle, ink, {0, 0, -1}); }

    // A picture in a box. It must live until the next draw(), as those from picture() do.
    void show(const Bytes& bytes, Point corner, Point opposite, bool smooth = true) {
        begin(Op::picture, ink,
              {corner.x, corner.y, opposite.x - corner.x, opposite.y - corner.y,
               static_cast<double>(bytes.columns), static_cast<double>(bytes.rows),
               smooth ? 1.0 : 0.0,
               static_cast<double>(reinterpret_cast<std::uintptr_t>(bytes.rgba.data()))});
    }
    // A new picture, which lives until the next draw().
    Bytes& picture(int columns, int rows) {
        pictures_.push_back(std::make_unique<Bytes>(columns, rows));
        return *pictures_.back();
    }

    // The numbers below the figure.
    template <class... Numbers>
    void say(std::string_view words, Numbers... numbers) {
        begin(Op::say, ink, {keep(words), static_cast<double>(numbers)...});
    }

    // A picture in the box from `corner` to `opposite` that gets better while you wait: see
    // refine.hpp. shade(column, row, sample) gives the color of one sample.
    using Shade = std::function<rt::Color(int column, int row, int sample)>;
    void refine(Point corner, Point opposite, int columns, int rows, int samples, Shade shade);

    // ---- For host.hpp ----
    void start(double page_width, double ratio);
    Refinement* refinement() const { return refinement_.get(); }
    std::span<const double> list() const { return list_; }
    const std::string& words() const { return words_; }

  private:
    enum class Op { path, polygon, disc, circle, text, handle, picture, say };

    // Every entry begins with its kind, how many numbers follow, and a color: its code and alpha.
    void begin(Op op, Ink color, std::initializer_list<double> numbers) {
        list_.insert(list_.end(), {static_cast<double>(op), static_cast<double>(numbers.size() + 2),
                                   color.code, color.alpha});
        last_ = list_.size() - 3;
        list_.insert(list_.end(), numbers);
    }
    void add(std::span<const Point> points) {
        for (const Point p : points) list_.insert(list_.end(), {p.x, p.y});
        list_[last_] += 2 * static_cast<double>(points.size());
    }
    // The number of a text among those that the page gets.
    double keep(std::string_view words) {
        words_.append(words).push_back('\0');
        return count_++;
    }

    std::vector<double> list_;
    std::size_t last_ = 0;  // where the last entry says how many numbers follow
    std::string words_;
    double count_ = 0;
    std::vector<std::unique_ptr<Bytes>> pictures_;
    std::unique_ptr<Refinement> refinement_;
};

}  // namespace live

#include "refine.hpp"
