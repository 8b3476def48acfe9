// The live figures of chapter 14.
#include <array>
#include <rt/rough_metal.hpp>
#include <rt/running_shares.hpp>
#include <rt/sample_rng.hpp>
#include <string_view>
#include <vector>

#include "controls.hpp"
#include "live.hpp"
#include "plane.hpp"
// The chapter's plates.
#include "plates.hpp"

namespace live {
namespace {

// ---- The entry that a number chooses ----

constexpr std::size_t entries = 4;
constexpr std::array entry_inks{blue, pink, amber, orange};
constexpr double most_weight = 6;

struct SharesLayout {
    double axis, column;       // x of the axis, and the width of an entry
    double top, bottom;        // of the staircase: y of the shares 1 and 0
    double bar_foot, bar_top;  // of the bars: y of the weights 0 and most_weight

    explicit SharesLayout(double width)
        : axis{width < 520 ? 64.0 : 0.16 * width},
          column{(width - axis - (width < 520 ? 0 : 0.1 * width)) / entries},
          top{22},
          bottom{232},
          bar_foot{402},
          bar_top{292} {}

    double x_of(std::size_t entry) const {
        return axis + (static_cast<double>(entry) + 0.5) * column;
    }
    double y_of(double share) const { return bottom + share * (top - bottom); }
    double bar_y(double weight) const {
        return bar_foot + weight / most_weight * (bar_top - bar_foot);
    }
    // The number's handle, then those of the bars.
    std::array<Point, 1 + entries> handles(const SharesControls& c) const {
        return {{{axis, y_of(c.number)},
                 {x_of(0), bar_y(c.w0)},
                 {x_of(1), bar_y(c.w1)},
                 {x_of(2), bar_y(c.w2)},
                 {x_of(3), bar_y(c.w3)}}};
    }
};

}  // namespace

void draw(const SharesControls& c, Drawing& out) {
    const SharesLayout layout{out.width};
    out.height = layout.bar_foot + 42;
    const std::vector<rt::Real> weights{c.w0, c.w1, c.w2, c.w3},
        shares = rt::running_shares(weights);
    // A number on the end of a step is the share itself, as it was rounded.
    double number = c.number;
    for (const double share : shares)
        if (std::abs(share - number) < 1e-12) number = share;
    const rt::Pick picked = rt::pick(shares, number);
    const bool is_chosen = picked.probability > 0;

    // Numbers that were thrown, each beside the axis at its height.
    std::array<int, entries> counts{};
    rt::Rng random = rt::sample_rng(14, 2, 0, 0);
    for (int i = 0; i < static_cast<int>(c.throws); ++i) {
        const double thrown = random.uniform();
        const rt::Pick one = rt::pick(shares, thrown);
        if (!(one.probability > 0)) continue;
        ++counts[one.index];
        out.disc({layout.axis - 14 - 22 * random.uniform(), layout.y_of(thrown)}, 2,
                 thin(entry_inks[one.index], 0.8));
    }

    // The staircase.
    const double end = layout.axis + entries * layout.column;
    out.bold = true;
    out.text({layout.axis + 10, layout.top + 16}, "running shares", ink, Align::left);
    out.text({layout.axis + 10, layout.bar_top - 18}, "weights", ink, Align::left);
    out.bold = false;
    out.line({layout.axis, layout.bottom}, {layout.axis, layout.top}, {muted, 1.2});
    for (const double share : {0.0, 0.5, 1.0}) {
        out.line({layout.axis, layout.y_of(share)}, {end, layout.y_of(share)}, {faint, 0.8});
        out.text({layout.axis - 44, layout.y_of(share)}, "{}", muted, Align::right, share);
    }
    double before = 0, from = layout.axis;
    for (std::size_t i = 0; i < entries; ++i) {
        const double x = layout.x_of(i), low = layout.y_of(before), high = layout.y_of(shares[i]);
        out.line({from, low}, {x, low}, {ink, 1.5});
        if (shares[i] > before) {
            out.line({x, low}, {x, high}, {entry_inks[i], 6});
            out.text({x + 9, high + 12}, "{}", ink, Align::left, shares[i]);
        }
        before = shares[i], from = x;
    }
    out.line({from, layout.y_of(before)}, {end, layout.y_of(before)}, {ink, 1.5});

    // The bars.
    const auto handles = layout.handles(c);
    const double half = std::min(34.0, 0.32 * layout.column);
    out.line({layout.axis, layout.bar_foot}, {end, layout.bar_foot}, {muted, 1.2});
    for (std::size_t i = 0; i < entries; ++i) {
        const Point top = handles[i + 1];
        const bool is_it = is_chosen && picked.index == i;
        out.box({top.x - half, top.y}, {top.x + half, layout.bar_foot},
                thin(entry_inks[i], is_it ? 0.75 : 0.3));
        out.bold = is_it;
        out.text({top.x, layout.bar_foot + 14}, "entry {}", ink, Align::middle, double(i));
        out.bold = false;
        if (c.throws > 0)
            out.text({top.x, layout.bar_foot + 32}, out.is_narrow() ? "{}" : "{} times", muted,
                     Align::middle, double(counts[i]));
        else
            out.text({top.x, layout.bar_foot + 32}, "weight {}", muted, Align::middle, weights[i]);
    }

    // From the number to the step that it meets, and down to its entry.
    if (is_chosen) {
        const Point step{layout.x_of(picked.index), handles[0].y},
            bar = handles[picked.index + 1] - Point{0, 14};
        out.line(handles[0], step, {accent, 2, 5});
        if (bar.y > layout.bottom + 8) out.arrow({step.x, layout.bottom + 6}, bar, {accent, 2});
        out.dot(step, accent, 4);
    }
    for (const Point& handle : handles) out.handle(handle);

    if (is_chosen)
        out.say(
            "The number {.3} chooses entry {}, whose share {.3} is the first that is greater. Its "
            "probability is {.3}, and the rest of the number is {.2}.",
            c.number, double(picked.index), shares[picked.index], picked.probability, picked.rest);
    else
        out.say("No share is greater than {.3}: there is nothing to choose.", c.number);
}

void drag(SharesControls& c, const Drag& to) {
    const SharesLayout layout{to.width};
    const auto handles = layout.handles(c);
    const std::size_t moved = nearest_of(handles, to.down);
    const double y = handles[moved].y + to.moved().y;
    if (moved == 0) {
        c.number = std::round(64 * (layout.bottom - y) / (layout.bottom - layout.top)) / 64;
        return;
    }
    const std::array weights{&c.w0, &c.w1, &c.w2, &c.w3};
    *weights[moved - 1] =
        std::round(2 * most_weight * (layout.bar_foot - y) / (layout.bar_foot - layout.bar_top)) /
        2;
}

// ---- Where a rough metal mirrors the eye ----

namespace {

struct LobeLayout {
    static constexpr double below = 0.5;  // what is shown below the surface, in radii

    Frame side, behind;  // of unit vectors: x and z; y and z, from behind the eye
    double height;

    explicit LobeLayout(double width) {
        const bool narrow = width < 520;
        const double radius = (narrow ? 0.42 : 0.22) * width, panel = (1 + below) * radius;
        side = {{(narrow ? 0.5 : 0.25) * width, radius + 34}, {}, radius};
        behind = {side.at + (narrow ? Point{0, panel + 46} : Point{0.5 * width, 0}), {}, radius};
        height = behind.at.y + below * radius + 12;
    }
};

rt::Vec3 eye_of(const LobeControls& c) {
    const double angle = rt::radians(c.angle);
    return {-std::sin(angle), 0, std::cos(angle)};
}

}  // namespace

void draw(const LobeControls& c, Drawing& out) {
    const LobeLayout layout{out.width};
    out.height = layout.height;
    const double alpha = c.roughness * c.roughness, radius = layout.side.scale;
    const rt::Vec3 eye = eye_of(c), mirror{-eye.x, 0, eye.z};
    const auto from_side = [&](rt::Vec3 v) { return layout.side.to_page({v.x, v.z}); };
    const auto from_behind = [&](rt::Vec3 v) { return layout.behind.to_page({v.y, v.z}); };

    // The surface: facets of this roughness, up and down by turns.
    std::vector<Point> surface;
    rt::Rng random = rt::sample_rng(14, 4, 0, 0);
    double x = -1.1, height = 0;
    while (x < 1.1) {
        surface.push_back(layout.side.to_page({x, height - 0.02}));
        const rt::Vec3 facet =
            rt::visible_facet({0, 0, 1}, alpha, {random.uniform(), random.uniform()});
        const double slope = std::min(2.0, std::hypot(facet.x, facet.y) / facet.z);
        height += (height > 0 ? -0.035 : 0.035) * slope;
        x += 0.035;
    }
    const double depth = LobeLayout::below * radius;
    std::vector<Point> metal = surface;
    metal.push_back({surface.back().x, layout.side.at.y + depth});
    metal.push_back({surface.front().x, layout.side.at.y + depth});
    const Point aside = layout.behind.at - layout.side.at;
    for (const Point offset : {Point{}, aside}) {
        for (auto* const points : {&metal, &surface})
            for (Point& point : *points) point = point + offset;
        out.polygon(metal, thin(sky, 0.25));
        out.path(surface, {ink, 1.5});
        draw_arc(out, layout.side.at + offset, radius, 0, rt::pi, {faint, 1.2});
    }

    // Directions, drawn at random.
    constexpr int count = 3000, shown_ones = 300;
    std::vector<double> along, across;  // angles from the mirror direction: up or down, sideways
    int lost = 0;
    for (int i = 0; i < count; ++i) {
        rt::Rng own = rt::sample_rng(14, 5, 0, i);
        const rt::Vec3 facet = rt::visible_facet(eye, alpha, {own.uniform(), own.uniform()}),
                       in = rt::mirrored_at(eye, facet);
        lost += !(in.z > 0);
        along.push_back(std::abs(in_degrees(std::atan2(in.x, in.z)) - c.angle));
        across.push_back(std::abs(in_degrees(std::asin(in.y))));
        if (i >= shown_ones) continue;
        const Ink color = thin(in.z > 0 ? green : orange, 0.65);
        if (in.z < 0.02 - LobeLayout::below) continue;
        out.disc(from_side(in), 2, color);
        out.disc(from_behind(in), 2, color);
    }
    for (auto* const angles : {&along, &across})
        std::nth_element(angles->begin(), angles->begin() + count / 2, angles->end());

    // Their density in the plane of the picture, the largest as long as the radius.
    std::vector<double> densities;
    for (int i = -180; i <= 180; ++i) {
        const double angle = rt::radians(i / 2.0);
        densities.push_back(
            rt::reflection_density(eye, {std::sin(angle), 0, std::cos(angle)}, alpha));
    }
    const double largest = *std::max_element(densities.begin(), densities.end());
    std::vector<Point> lobe;
    for (int i = -180; i <= 180; ++i) {
        const double angle = rt::radians(i / 2.0),
                     far = densities[static_cast<std::size_t>(i + 180)] / largest;
        lobe.push_back(layout.side.to_page({far * std::sin(angle), far * std::cos(angle)}));
    }
    out.polygon(lobe, thin(blue, 0.2));
    out.path(lobe, {blue, 2});

    out.arrow(layout.side.at, from_side(eye), {accent, 3});
    out.line(layout.side.at, from_side(mirror), {muted, 1.5, 5});
    out.line(layout.behind.at, from_behind(mirror), {muted, 1.5, 5});
    out.bold = true;
    out.text(from_side(eye) - Point{0, 20}, "out", accent);
    out.text(layout.side.at - Point{radius, radius + 24}, "from the side", ink, Align::left);
    out.text(layout.behind.at - Point{radius, radius + 24}, "from behind the eye", ink,
             Align::left);
    out.bold = false;
    if (lost > 0)
        out.text(layout.side.at + Point{0, depth - 16}, "below the surface: lost", orange);
    out.handle(from_side(eye));

    out.say(
        "Half of the directions are within {.0}° of the mirror direction up or down, and half are "
        "within {.0}° of it to the side. Of 100, {.0} lead below the surface.",
        along[count / 2], across[count / 2], 100.0 * lost / count);
}

void drag(LobeControls& c, const Drag& to) {
    const LobeLayout layout{to.width};
    const rt::Vec3 eye = eye_of(c);
    const Point now = layout.side.to_plane(layout.side.to_page({eye.x, eye.z}) + to.moved());
    c.angle = std::clamp(in_degrees(std::atan2(-now.x, std::max(now.y, 0.0))), 0.0, 88.0);
}

// ---- Two ways to find a lamp ----

namespace {

// Over many samples and bounces from a plate to one lamp, in the middle of what the plate mirrors,
// as in the chapter's study: what is needed to know the error of every fixed weight.
struct PlateErrors {
    double samples = 0, bounces = 0, both = 0;  // mean squares, and the mean product
    double mean = 0;
    std::array<double, 2> heuristics{};  // the relative error of one of each

    PlateErrors(double spread, double radius) {
        using namespace rt;
        constexpr int count = 60'000;
        const Vec3 incoming = normalize({1, -1, 0});
        Hit hit;
        hit.normal = {0, 1, 0};
        hit.front = true;
        const Lobe plate{{1, 1, 1}, 1 / (spread * spread)};
        const Sphere lamp{4 * normalize({1, 1, 0}), radius};
        const double of_samples = light_density(lamp, {});
        std::array<double, 2> squares{};
        Rng random{14, 2};
        for (int i = 0; i < count; ++i) {
            const auto sample = sample_light(lamp, {}, random_place(random));
            const auto bounce = scatter(plate, incoming, hit, random);
            if (!sample || !bounce) continue;
            const double toward = scatter_density(plate, incoming, hit, sample->direction),
                         drawn = scatter_density(plate, incoming, hit, bounce->direction),
                         of_sample = toward / sample->density,
                         of_bounce =
                             hit_sphere(lamp, Ray{{}, bounce->direction}, {0, infinity}) ? 1 : 0;
            samples += of_sample * of_sample / count;
            bounces += of_bounce * of_bounce / count;
            both += of_sample * of_bounce / count;
            for (std::size_t k = 0; k < 2; ++k) {
                const Ways ways = k == 0 ? Ways::balance : Ways::power;
                double light = 0;
                if (toward > 0)
                    light += of_sample * way_weight(ways, Way::sample, sample->density, toward);
                if (of_bounce > 0) light += way_weight(ways, Way::bounce, drawn, of_samples);
                squares[k] += light * light / count;
                if (k == 0) mean += light / count;
            }
        }
        for (std::size_t k = 0; k < 2; ++k) heuristics[k] = relative(squares[k]);
    }
    double relative(double square) const {
        return std::sqrt(std::max(0.0, square - mean * mean)) / mean;
    }
    // The relative error of a sample and a bounce, where the bounce has this weight.
    double fixed(double w) const {
        return relative((1 - w) * (1 - w) * samples + 2 * w * (1 - w) * both + w * w * bounces);
    }
};

constexpr double plates_aspect = 0.66;

}  // namespace

void draw(const PlatesControls& c, Drawing& out) {
    const bool narrow = out.is_narrow();
    const double gap = 12, title = 26;
    const double wide = narrow ? out.width : (out.width - gap) / 2, high = wide * plates_aspect;
    const int columns = static_cast<int>(std::min(wide * out.pixel_ratio, 360.0)),
              rows = static_cast<int>(columns * plates_aspect);
    out.height = narrow ? 2 * high : high + title;

    rt::SceneDescription description;
    description.camera.view = light::plates_view();
    const auto make = [&](rt::Ways ways) {
        return std::make_shared<light::PlatesScene>(description, columns, rows, ways);
    };
    const auto scene = make(rt::Ways::samples);
    const rt::Ways heuristic = c.heuristic == 0 ? rt::Ways::balance : rt::Ways::power;
    const double weight = c.bounces;
    const Point corner{0, narrow ? 0 : title};
    out.refine(corner, {out.width, out.height}, narrow ? columns : 2 * columns,
               narrow ? 2 * rows : rows, static_cast<int>(c.samples),
               [scene, heuristic, weight, columns, rows](int column, int row, int sample) {
                   const bool is_first = column < columns && row < rows;
                   column %= columns, row %= rows;
                   const auto light = [&](rt::Ways ways) {
                       rt::Rng random = rt::sample_rng(1, column, row, sample);
                       const rt::Ray ray =
                           rt::primary_ray(scene->camera, column, row, rt::random_place(random));
                       return two_way_radiance(ray, scene->world, scene->materials, scene->sky,
                                               scene->lights.lamps, ways, scene->fog,
                                               rt::SkyEnding{}, 3, random);
                   };
                   if (!is_first) return light(heuristic);
                   // The same paths, once with samples alone and once with bounces alone.
                   rt::Color sum;
                   if (weight < 1) sum += (1 - weight) * light(rt::Ways::samples);
                   if (weight > 0) sum += weight * light(rt::Ways::bounces);
                   return sum;
               });
    const Point middle{out.width / 2, (corner.y + out.height) / 2};
    if (narrow)
        out.box(middle - Point{middle.x, 3}, middle + Point{middle.x, 3}, paper);
    else
        out.box({middle.x - gap / 2, corner.y}, {middle.x + gap / 2, out.height}, paper);
    const std::string_view first = weight == 0   ? "Samples alone"
                                   : weight == 1 ? "Bounces alone"
                                                 : "Samples {.2}, bounces {.2}",
                           second = c.heuristic == 0 ? "Balance heuristic" : "Power heuristic";
    out.bold = true;
    out.on_picture = narrow;
    const Point left = narrow ? Point{10, 16} : Point{0, 12},
                right = narrow ? Point{10, high + 16} : Point{wide + gap, 12};
    out.text(left, first, ink, Align::left, 1 - weight, weight);
    out.text(right, second, ink, Align::left);
    out.bold = out.on_picture = false;
    out.handle_everywhere();

    static const PlateErrors sharp{0.006, 0.9}, dull{0.2, 0.0333};
    out.say(
        "Error of one sample and one bounce, as a multiple of the light: of the largest lamp in "
        "the sharpest plate {.2}, in the second picture {.2}; of the smallest lamp in the dullest "
        "plate {.2} and {.2}.",
        sharp.fixed(weight), sharp.heuristics[static_cast<std::size_t>(c.heuristic)],
        dull.fixed(weight), dull.heuristics[static_cast<std::size_t>(c.heuristic)]);
}

void drag(PlatesControls& c, const Drag& to) {
    c.bounces += 1.2 * to.moved().x / to.width;
}

}  // namespace live
