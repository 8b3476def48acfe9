// The live figures of chapter 11.
#include <array>
#include <bit>
#include <rt/jitter.hpp>
#include <rt/lambertian.hpp>
#include <rt/lit_path.hpp>
#include <rt/make_camera.hpp>
#include <rt/material_set.hpp>
#include <rt/rng.hpp>
#include <rt/running_variance.hpp>
#include <rt/sample_rng.hpp>
#include <rt/sky.hpp>
#include <rt/sobol_samples.hpp>
#include <rt/sphere_list.hpp>
#include <rt/twin_halves.hpp>

#include "controls.hpp"
#include "found_by_chance.hpp"
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

// ---- Where adaptive samples go ----

namespace {

constexpr int columns = 72, rows = 48, tile_side = 6, tiles_across = columns / tile_side,
              tile_count = tiles_across * rows / tile_side;
constexpr int pilot = 4;                                    // samples of a pixel, in each half
constexpr int budget_step = 8, budgets = 64 / budget_step;  // samples of a pixel, in both halves

std::size_t tile_of(int x, int y) {
    return static_cast<std::size_t>(y / tile_side * tiles_across + x / tile_side);
}

// Three balls in the light of a lamp above the picture. A small lamp gives as much light as a large
// one.
struct Lamplight {
    rt::SphereList world;
    rt::MaterialSet<rt::Lambertian> materials;
    rt::SceneLights lights;
    FoundByChance by_chance;
    rt::Camera camera =
        rt::make_camera({{0, 2.6, 8}, {0, 0.75, 0}, {0, 1, 0}, rt::radians(26)}, columns, rows);

    explicit Lamplight(double lamp_radius) {
        materials.materials = {rt::Lambertian{rt::from_hex(0xb9b2a8)},
                               rt::Lambertian{rt::from_hex(0xe9e2d4)},
                               rt::Lambertian{rt::from_hex(0xe8b060)},
                               rt::Lambertian{rt::from_hex(0x4f7fb0)}, rt::Lambertian{}};
        const rt::Sphere lamp{{-2, 4.2, 2}, lamp_radius};
        world.spheres = {{{{0, -600, 0}, 600}, 0},
                         {{{-0.1, 0.9, 0}, 0.9}, 1},
                         {{{1.75, 0.6, 0.5}, 0.6}, 2},
                         {{{-1.6, 0.45, 0.9}, 0.45}, 3},
                         {lamp, 4, 0}};
        lights.add({lamp, 9 / (lamp_radius * lamp_radius) * rt::Color{1, 0.86, 0.66}, 0, 4});
        by_chance = {lights};
    }

    rt::Color sample(bool finds_by_chance, int half, int x, int y, int number) const {
        rt::Rng random = rt::sample_rng(static_cast<std::uint64_t>(half + 1), x, y, number);
        const rt::Ray ray = primary_ray(camera, x, y, random_place(random));
        const auto light = [&](const auto& found) {
            return lit_path_radiance(ray, world, materials,
                                     rt::GradientSky{{0.02, 0.03, 0.05}, {0.07, 0.1, 0.16}}, found,
                                     rt::NoFog{}, rt::SkyEnding{}, 2, random);
        };
        return finds_by_chance ? light(by_chance) : light(lights);
    }
};

using Counts = std::array<rt::Halves<int>, tile_count>;

// A picture in two halves, with these samples of each of a tile's pixels.
struct Drawn {
    Counts counts{};
    std::array<std::array<rt::ColorSum, 2>, columns * rows> sums{};

    template <class Sample>
    void go_on(const Counts& wanted, const Sample& sample) {
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x) {
                const auto [first, second] = counts[tile_of(x, y)];
                const auto [more, more_second] = wanted[tile_of(x, y)];
                auto& sum = sums[static_cast<std::size_t>(y * columns + x)];
                for (int i = first; i < more; ++i) sum[0].add(sample(0, x, y, i));
                for (int i = second; i < more_second; ++i) sum[1].add(sample(1, x, y, i));
            }
        counts = wanted;
    }
    rt::Halves<rt::Color> means(int x, int y) const {
        const auto& sum = sums[static_cast<std::size_t>(y * columns + x)];
        const auto [first, second] = counts[tile_of(x, y)];
        return {sum[0].mean(first), sum[1].mean(second)};
    }
    // Calls use(x, y, channel of the color, both halves' means).
    template <class Use>
    void each_channel(const Use& use) const {
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x) {
                const auto [first, second] = means(x, y);
                for (const auto channel : {&rt::Color::r, &rt::Color::g, &rt::Color::b})
                    use(x, y, channel, rt::Halves<rt::Real>{first.*channel, second.*channel});
            }
    }
};

// What a picture shows after a budget, and its error, estimated from its halves.
struct Shot {
    Counts counts;
    std::vector<rt::Color> pixels;
    double error;

    explicit Shot(const Drawn& drawn) : counts{drawn.counts}, pixels(columns * rows) {
        double squares = 0;
        drawn.each_channel([&](int x, int y, auto channel, rt::Halves<rt::Real> mean) {
            pixels[static_cast<std::size_t>(y * columns + x)].*channel = rt::twin_mean(mean);
            squares += rt::twin_square_error(mean);
        });
        error = std::sqrt(squares / (3 * columns * rows));
    }
    // Samples of each pixel of a tile, in both halves.
    int in(std::size_t tile) const { return counts[tile].first + counts[tile].second; }
};

// Both ways to spend a budget, for all budgets.
struct Spent {
    std::vector<Shot> equal, adaptive;
    std::array<rt::Halves<rt::Real>, tile_count> spread{};
    rt::Halves<rt::Real> mean_spread;

    Spent(double lamp_radius, bool finds_by_chance) {
        const Lamplight scene{lamp_radius};
        const auto sample = [&](int half, int x, int y, int number) {
            return scene.sample(finds_by_chance, half, x, y, number);
        };
        find_spreads(sample);
        const auto even = std::make_unique<Drawn>(), uneven = std::make_unique<Drawn>();
        for (int budget = budget_step; budget <= budgets * budget_step; budget += budget_step) {
            Counts same;
            same.fill({budget / 2, budget / 2});
            even->go_on(same, sample);
            uneven->go_on(counts_for(budget), sample);
            equal.emplace_back(*even);
            adaptive.emplace_back(*uneven);
        }
    }

  private:
    // The standard deviation of a channel of one sample, in each tile, as each half's pilot sees
    // it.
    template <class Sample>
    void find_spreads(const Sample& sample) {
        std::array<rt::Halves<double>, tile_count> sum{};
        const auto variances = [&](int half, int x, int y) {
            std::array<rt::Color, pilot> seen{};
            for (int i = 0; i < pilot; ++i)
                seen[static_cast<std::size_t>(i)] = sample(half, x, y, i);
            rt::Real all = 0;
            for (const auto channel : {&rt::Color::r, &rt::Color::g, &rt::Color::b}) {
                rt::RunningVariance known;
                for (const rt::Color& color : seen) add(known, color.*channel);
                all += variance(known);
            }
            return all;
        };
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x) {
                sum[tile_of(x, y)].first += variances(0, x, y);
                sum[tile_of(x, y)].second += variances(1, x, y);
            }
        constexpr double numbers = 3 * tile_side * tile_side;
        for (std::size_t tile = 0; tile < tile_count; ++tile) {
            spread[tile] = {std::sqrt(sum[tile].first / numbers),
                            std::sqrt(sum[tile].second / numbers)};
            mean_spread.first += spread[tile].first / tile_count;
            mean_spread.second += spread[tile].second / tile_count;
        }
    }

    // The counts of all tiles for this error.
    Counts counts_at(double error) const {
        Counts counts;
        for (std::size_t tile = 0; tile < tile_count; ++tile)
            counts[tile] = rt::crossed_counts(spread[tile], mean_spread, error, {pilot, 1 << 20});
        return counts;
    }
    // Each half spends half of the budget, at the smallest error for which that is enough.
    Counts counts_for(int budget) const {
        Counts counts;
        for (const auto half : {&rt::Halves<int>::first, &rt::Halves<int>::second}) {
            double low = 1e-5, high = 1e5;
            for (int step = 0; step < 50; ++step) {
                const double middle = std::sqrt(low * high);
                std::int64_t all = 0;
                for (const rt::Halves<int>& count : counts_at(middle)) all += count.*half;
                (all > tile_count * budget / 2 ? low : high) = middle;
            }
            const Counts at = counts_at(high);
            for (std::size_t tile = 0; tile < tile_count; ++tile)
                counts[tile].*half = at[tile].*half;
        }
        return counts;
    }
};

const Spent& spent(const AdaptiveControls& c) {
    static std::unique_ptr<const Spent> last;
    static double radius, lamp;
    if (!last || radius != c.radius || lamp != c.lamp)
        last = std::make_unique<Spent>(radius = c.radius, (lamp = c.lamp) > 0);
    return *last;
}

struct AdaptiveLayout {
    std::array<Point, 3> corner;  // of the pictures: equal, adaptive, and the map
    double pixel;                 // of a picture
    Point chart, chart_end;
    double height;

    Point size() const { return pixel * Point{columns, rows}; }
    Point tile(std::size_t picture, double column, double row) const {
        return corner[picture] + pixel * tile_side * Point{column, row};
    }
    double x(double samples) const {
        return chart.x +
               (chart_end.x - chart.x) * std::log2(samples / budget_step) / std::log2(budgets);
    }
};

AdaptiveLayout adaptive_layout(double width) {
    constexpr double above = 24, gap = 12;
    if (width < 520) {
        const double wide = (width - gap) / 2, pixel = wide / columns, high = pixel * rows;
        const double chart = 2 * (above + high) + above + 14;
        return {{{{0, above}, {wide + gap, above}, {0, 2 * above + high + 4}}},
                pixel,
                {46, chart},
                {width - 12, chart + 150},
                chart + 186};
    }
    const double wide = (width - 2 * gap) / 3, pixel = wide / columns, high = pixel * rows;
    const double chart = 2 * above + high + 12;
    return {{{{0, above}, {wide + gap, above}, {2 * (wide + gap), above}}},
            pixel,
            {48, chart},
            {width - 130, chart + 150},
            chart + 188};
}

std::size_t chosen_tile(const AdaptiveControls& c) {
    return static_cast<std::size_t>((c.row - 1) * tiles_across + c.column - 1);
}

// The errors of both ways by the budget, and the equal number that reaches the same error.
void draw_errors(Drawing& out, const AdaptiveLayout& layout, const Spent& all, std::size_t now,
                 double needed) {
    const Point corner = layout.chart, opposite = layout.chart_end;
    const double high = 1.2 * std::max(all.equal.front().error, all.adaptive.front().error),
                 low = std::min(all.equal.back().error, all.adaptive.back().error) / 1.2;
    const auto at = [&](double samples, double error) {
        return Point{
            layout.x(samples),
            corner.y + (opposite.y - corner.y) * std::log(high / error) / std::log(high / low)};
    };
    for (double power = 1e-4; power < 100; power *= 10)
        for (const double error : {power, 2 * power, 3 * power, 5 * power, 7 * power}) {
            if (error < low || error > high) continue;
            out.line(at(budget_step, error), {opposite.x, at(1, error).y}, {faint, 1});
            out.text(at(budget_step, error) + Point{-6, 0}, "{}", muted, Align::right, error);
        }
    for (const int samples : {8, 16, 32, 64})
        out.text({layout.x(samples), opposite.y + 14}, "{}", muted, Align::middle, samples);
    out.line({corner.x, opposite.y}, opposite, {muted, 1});
    out.text({corner.x - 30, corner.y - 14},
             out.is_narrow() ? "error by samples per pixel"
                             : "error by samples per pixel, estimated from the halves",
             muted, Align::left);

    const auto budget = [](std::size_t i) { return budget_step * static_cast<double>(i + 1); };
    const auto curve = [&](const std::vector<Shot>& shots, Ink color) {
        std::vector<Point> points;
        for (std::size_t i = 0; i < shots.size(); ++i)
            points.push_back(at(budget(i), shots[i].error));
        out.path(points, {color, 2});
        return points.back();
    };
    const Point equal_end = curve(all.equal, orange), adaptive_end = curve(all.adaptive, blue);
    if (!out.is_narrow()) {
        const double middle = (equal_end.y + adaptive_end.y) / 2,
                     apart = std::max(9.0, std::abs(equal_end.y - adaptive_end.y) / 2);
        const double side = equal_end.y < adaptive_end.y ? -apart : apart;
        out.text({opposite.x + 10, middle + side}, "the same number", orange, Align::left);
        out.text({opposite.x + 10, middle - side}, "adaptive", blue, Align::left);
    }
    const Point equal = at(budget(now), all.equal[now].error),
                adaptive = at(budget(now), all.adaptive[now].error);
    out.line({adaptive.x, corner.y}, {adaptive.x, opposite.y}, {muted, 1, 3});
    out.line(adaptive, {std::clamp(layout.x(needed), corner.x, opposite.x), adaptive.y},
             {blue, 1.5, 4});
    out.dot(equal, orange, 4);
    out.handle(adaptive);
    out.dot(adaptive, blue, 4);
}

}  // namespace

void draw(const AdaptiveControls& c, Drawing& out) {
    const AdaptiveLayout layout = adaptive_layout(out.width);
    out.height = layout.height;
    const Spent& all = spent(c);
    const auto now = static_cast<std::size_t>(c.budget / budget_step) - 1;
    const Shot &equal = all.equal[now], &adaptive = all.adaptive[now];
    int least = adaptive.in(0), most = least;
    for (std::size_t tile = 0; tile < tile_count; ++tile) {
        least = std::min(least, adaptive.in(tile));
        most = std::max(most, adaptive.in(tile));
    }

    const std::size_t chosen = chosen_tile(c);
    const double ratio = equal.error / adaptive.error, needed = c.budget * ratio * ratio;
    draw_errors(out, layout, all, now, needed);
    Bytes &same = out.picture(columns, rows), &better = out.picture(columns, rows),
          &map = out.picture(tiles_across, rows / tile_side);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const auto pixel = static_cast<std::size_t>(y * columns + x);
            same.set(x, y, equal.pixels[pixel]);
            better.set(x, y, adaptive.pixels[pixel]);
        }
    for (std::size_t tile = 0; tile < tile_count; ++tile) {
        const double bright = 1.0 * (adaptive.in(tile)-least) / std::max(1, most - least);
        map.set(static_cast<int>(tile) % tiles_across, static_cast<int>(tile) / tiles_across,
                rt::mix(rt::from_hex(0x14213d), rt::from_hex(0xffd166), bright));
    }
    const std::array<const Bytes*, 3> pictures{&same, &better, &map};
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        out.show(*pictures[i], layout.corner[i], layout.corner[i] + layout.size(), false);
        const Point tile = layout.tile(i, c.column - 1, c.row - 1),
                    end = layout.tile(i, c.column, c.row);
        out.frame(tile, end, {paper, 5});
        out.frame(tile, end, {pink, 2.5});
        out.handle(layout.corner[i] + 0.5 * layout.size(),
                   0.5 * std::hypot(layout.size().x, layout.size().y), false);
    }
    const auto title = [&](std::size_t i) { return layout.corner[i] - Point{0, 12}; };
    out.bold = true;
    out.text(title(0), "{} in each pixel", orange, Align::left, c.budget);
    out.text(title(1), "{} on average", blue, Align::left, c.budget);
    out.text(title(2), out.is_narrow() ? "in each tile" : "in each tile: from {} to {}", ink,
             Align::left, least, most);
    out.bold = false;
    if (out.is_narrow()) {
        const Point beside = layout.corner[2] + Point{layout.size().x + 12, 14};
        out.text(beside, "dark: {} samples", muted, Align::left, least);
        out.text(beside + Point{0, 20}, "bright: {} samples", muted, Align::left, most);
    }
    out.say(
        adaptive.error < equal.error
            ? "With the same number in each pixel the error is {.4}; if each tile gets its share, "
              "it is {.4}, for which {.0} in each pixel would be needed. In the marked tile, the "
              "halves’ pilots saw the spreads {.3} and {.3}, so the halves took {} and {} samples."
            : "With the same number in each pixel the error is {.4}; by the pilots it is {.4}, as "
              "with {.0} in each pixel: where no pilot met the lamp, tiles got the fewest. In the "
              "marked tile, they saw the spreads {.3} and {.3}, so the halves took {} and {} "
              "samples.",
        equal.error, adaptive.error, needed, all.spread[chosen].first, all.spread[chosen].second,
        adaptive.counts[chosen].first, adaptive.counts[chosen].second);
}

void drag(AdaptiveControls& c, const Drag& to) {
    const AdaptiveLayout layout = adaptive_layout(to.width);
    for (const Point corner : layout.corner) {
        const Point in = to.at - corner, down = to.down - corner, size = layout.size();
        if (down.x < 0 || down.y < 0 || down.x > size.x || down.y > size.y) continue;
        c.column = std::floor(in.x / layout.pixel / tile_side) + 1;
        c.row = std::floor(in.y / layout.pixel / tile_side) + 1;
        return;
    }
    // Along the chart, twice the number is everywhere as far.
    const double grown = std::pow(budgets, to.moved().x / (layout.chart_end.x - layout.chart.x));
    c.budget = budget_step * std::round(c.budget * grown / budget_step);
}

}  // namespace live
