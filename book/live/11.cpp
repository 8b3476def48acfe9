// The live figures of chapter 11.
#include <array>
#include <bit>
#include <rt/jitter.hpp>
#include <rt/rng.hpp>
#include <rt/sobol_samples.hpp>

#include "controls.hpp"
#include "live.hpp"
#include "plane.hpp"

namespace live {
namespace {

// ---- Points in a pixel ----

enum Way { at_random, jittered, sobol };
constexpr std::array ways{at_random, jittered, sobol};
constexpr std::array names{"Random", "Jittered", "Sobol’s points"};
constexpr std::array colors{orange, blue, green};

constexpr int most = 64, pixels = 200;

// The samples of a pixel; y is upward.
std::vector<rt::Vec2> points_of(Way way, int count, int pixel) {
    std::vector<rt::Vec2> points;
    rt::Rng random = rt::pixel_rng(1, pixel, 0);
    if (way == jittered)
        rt::pixel_average(count, random, [&](rt::Vec2 offset) {
            points.push_back(offset);
            return rt::Color{};
        });
    else
        for (int i = 0; i < count; ++i) {
            rt::SobolRandom own{1, pixel, 0, static_cast<std::uint32_t>(i)};
            points.push_back(way == sobol ? random_place(own) : random_place(random));
        }
    return points;
}

// An edge from the left side of a pixel to its right side, with light above it.
struct Edge {
    double left, right;

    double height(double x) const { return left + (right - left) * x; }
    // The part of the pixel that is in the light, as these points see it.
    double light(std::span<const rt::Vec2> points) const {
        const auto bright = std::count_if(points.begin(), points.end(), [&](rt::Vec2 point) {
            return point.y > height(point.x);
        });
        return static_cast<double>(bright) / static_cast<double>(points.size());
    }
    double exact() const { return 1 - (left + right) / 2; }
};

// The root mean square error of many pixels with this edge.
double error_of(Way way, int count, Edge edge) {
    static std::array<std::array<std::vector<rt::Vec2>, pixels>, most + 1> all[ways.size()];
    double squares = 0;
    for (int pixel = 0; pixel < pixels; ++pixel) {
        std::vector<rt::Vec2>& points =
            all[way][static_cast<std::size_t>(count)][static_cast<std::size_t>(pixel)];
        if (points.empty()) points = points_of(way, count, pixel + 1);
        const double error = edge.light(points) - edge.exact();
        squares += error * error;
    }
    return std::sqrt(squares / pixels);
}

struct PointsLayout {
    double side;                  // of a square
    std::array<Point, 3> corner;  // upper left
    Point chart, chart_end;
    double height;

    Point at(std::size_t square, double x, double y) const {
        return corner[square] + side * Point{x, 1 - y};
    }
};

PointsLayout points_layout(double width) {
    constexpr double rim = 10, above = 26, below = 30;
    if (width < 520) {
        const double side = (width - 2 * rim - 24) / 2, second = rim + side + 24,
                     lower = above + side + below + above;
        return {side,
                {{{rim, above}, {second, above}, {rim, lower}}},
                {second + 20, lower},
                {rim + 2 * side + 24, lower + side - 18},
                lower + side + below};
    }
    const double side = (width - 2 * rim - 56) / 3, under = above + side + below + 34;
    return {side,
            {{{rim, above}, {rim + side + 28, above}, {rim + 2 * side + 56, above}}},
            {rim + 34, under},
            {width - 120, under + 130},
            under + 166};
}

// The points, and boxes of equal size: green with one point, pink with more.
void draw_square(Drawing& out, const PointsLayout& layout, Way way, Edge edge,
                 std::span<const rt::Vec2> points, int columns, int rows) {
    const auto at = [&](double x, double y) { return layout.at(way, x, y); };
    std::vector<int> found(static_cast<std::size_t>(columns * rows));
    for (const rt::Vec2 point : points)
        ++found[static_cast<std::size_t>(static_cast<int>(point.y * rows) * columns +
                                         static_cast<int>(point.x * columns))];
    out.polygon({at(0, 0), at(0, edge.left), at(1, edge.right), at(1, 0)}, thin(muted, 0.35));
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int here = found[static_cast<std::size_t>(row * columns + column)];
            const auto corner = [&](int right, int up) {
                return at(static_cast<double>(column + right) / columns,
                          static_cast<double>(row + up) / rows);
            };
            if (here > 0) out.box(corner(0, 0), corner(1, 1), thin(here > 1 ? pink : green, 0.3));
        }
    for (int column = 0; column <= columns; ++column)
        out.line(at(1.0 * column / columns, 0), at(1.0 * column / columns, 1), {muted, 0.7});
    for (int row = 0; row <= rows; ++row)
        out.line(at(0, 1.0 * row / rows), at(1, 1.0 * row / rows), {muted, 0.7});
    out.line(at(0, edge.left), at(1, edge.right), {ink, 2.5});
    for (const rt::Vec2 point : points) {
        out.disc(at(point.x, point.y), 4.2, ink);
        if (point.y > edge.height(point.x)) out.disc(at(point.x, point.y), 2.8, paper);
    }
    for (const double x : {0.0, 1.0}) out.handle(at(x, edge.height(x)));

    const double value = edge.light(points);
    out.bold = true;
    out.text(at(0, 1) + Point{0, -13}, names[way], colors[way], Align::left);
    out.bold = false;
    out.text(at(0.5, 0) + Point{0, 16}, "light {.3}, exact {.3}", ink, Align::middle, value,
             edge.exact());
}

void draw_chart(Drawing& out, const PointsLayout& layout, Edge edge, int now) {
    constexpr std::array counts{1, 2, 3, 4, 6, 8, 9, 12, 16, 24, 25, 32, 36, 48, 49, 64};
    const Point corner = layout.chart, opposite = layout.chart_end;
    const auto at = [&](double count, double error) {
        const double down = std::clamp(-std::log10(error / 0.5) / 2.3, 0.0, 1.0);
        return Point{corner.x + (opposite.x - corner.x) * std::log2(count) / 6,
                     corner.y + (opposite.y - corner.y) * down};
    };
    for (const double error : {0.1, 0.01}) {
        out.line(at(1, error), at(most, error), {faint, 1});
        out.text(at(1, error) + Point{-5, 0}, "{}", muted, Align::right, error);
    }
    for (const int count : {1, 4, 16, 64})
        out.text({at(count, 1).x, opposite.y + 12}, "{}", muted, Align::middle, count);
    out.line({corner.x, opposite.y}, opposite, {muted, 1});
    out.line({at(now, 1).x, corner.y}, {at(now, 1).x, opposite.y}, {muted, 1, 3});
    for (const Way way : ways) {
        std::vector<Point> points;
        for (const int count : counts) points.push_back(at(count, error_of(way, count, edge)));
        out.path(points, {colors[way], 2});
        out.dot(at(now, error_of(way, now, edge)), colors[way], 4);
    }
    if (out.is_narrow()) {
        out.text({corner.x - 20, corner.y - 13}, "error by samples", muted, Align::left);
        return;
    }
    out.text({corner.x, corner.y - 14},
             "error by the number of samples: root mean square of {} pixels", muted, Align::left,
             pixels);
    // The names, from the largest error down, where they do not meet.
    std::array<Way, ways.size()> order = ways;
    const auto end = [&](Way way) { return at(most, error_of(way, most, edge)); };
    std::sort(order.begin(), order.end(), [&](Way a, Way b) { return end(a).y < end(b).y; });
    double y = 0;
    for (const Way way : order) {
        y = std::max(y + 17, std::min(end(way).y, opposite.y - 20));
        out.text({opposite.x + 10, y}, names[way], colors[way], Align::left);
    }
}

}  // namespace

void draw(const PointsControls& c, Drawing& out) {
    const PointsLayout layout = points_layout(out.width);
    out.height = layout.height;
    const int count = static_cast<int>(c.count);
    const Edge edge{c.left, c.right};
    // As many boxes as points, or as the next power of two.
    const int halvings = std::bit_width(static_cast<unsigned>(count - 1)),
              across = std::min(static_cast<int>(c.cut), halvings), columns = 1 << across,
              rows = 1 << (halvings - across);
    std::array<double, ways.size()> errors{};
    for (const Way way : ways) {
        const auto points = points_of(way, count, static_cast<int>(c.pixel));
        errors[way] = error_of(way, count, edge);
        draw_square(out, layout, way, edge, points, columns, rows);
    }
    draw_chart(out, layout, edge, count);
    out.say(
        "Samples: {}; boxes: {} × {}. Over {} pixels the error is {.3} with random points, {.3} "
        "with jittered ones and {.3} with Sobol’s.",
        count, columns, rows, pixels, errors[at_random], errors[jittered], errors[sobol]);
}

void drag(PointsControls& c, const Drag& to) {
    const PointsLayout layout = points_layout(to.width);
    std::array<Point, 6> handles;
    for (std::size_t square = 0; square < 3; ++square) {
        handles[2 * square] = layout.at(square, 0, c.left);
        handles[2 * square + 1] = layout.at(square, 1, c.right);
    }
    (nearest_of(handles, to.down) % 2 == 0 ? c.left : c.right) -= to.moved().y / layout.side;
}

}  // namespace live
