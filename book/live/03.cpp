// The live figures of chapter 03.
#include <array>
#include <rt/cross.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/nearest_sphere.hpp>

#include "03.float.hpp"
#include "controls.hpp"
#include "live.hpp"
#include "plane.hpp"

namespace live {
namespace {

// ---- A ray and a sphere ----

constexpr double start_x = -4, tip_x = 2.3;  // where the ray's ends are in the figure

Frame roots_frame(double width) {
    const double scale = width / 7.4;
    return {{0.5 * width, (width < 520 ? 0.32 : 0.25) * width}, {-0.85, 0}, scale};
}

// The ray as it is: it starts at the distance that the slider gives, on the line that you see.
rt::Ray far_ray(const RootsControls& c) {
    const rt::Vec3 d{1, c.slope, 0};
    const double back = std::pow(10, c.far) + start_x;
    return {rt::Vec3{start_x, c.height, 0} - back * d, d};
}

void draw_line(const RootsControls& c, const Frame& at, Drawing& out) {
    const Point start = at.to_page({start_x, c.height}),
                tip = at.to_page({tip_x, c.height + (tip_x - start_x) * c.slope});
    const Point edge{out.width, tip.y - (out.width - tip.x) * c.slope};
    out.line(tip, edge, {muted, 1.5, 5});
    if (!out.is_narrow()) out.text(edge + Point{-6, 20}, "the line goes on", muted, Align::right);
    out.arrow(start, tip, {accent, 1.5});
    const Point along = at.to_page({start_x + 1, c.height + c.slope});
    out.arrow(start, along, {accent, 3.5});
    if (c.far > 0.61) {  // a gap: the ray starts far to the left
        const Point cut = start + 0.28 * (tip - start);
        for (const double side : {-4.0, 4.0})
            out.line(cut + Point{side - 4, 9}, cut + Point{side + 4, -9}, {muted, 1.5});
        out.text(start + Point{0, 26}, "{} radii away", muted, Align::left, std::pow(10, c.far));
    }
    out.handle(start);
    out.handle(tip);
    out.text(start + Point{0, -24}, "O", ink);
    out.text(0.5 * (start + along) + Point{0, -15}, "d", accent);
}

}  // namespace

void draw(const RootsControls& c, Drawing& out) {
    const Frame at = roots_frame(out.width);
    out.height = 2 * at.at.y;
    const rt::Ray ray = far_ray(c);
    const rt::Sphere sphere{{0, 0, 0}, 1};
    const Point center = at.to_page({0, 0});

    // Half of the chord h, the distance p of the line from the center, and the discriminant: what
    // the drawing rests on, so that an answer that is wrong is seen beside it.
    const rt::Vec3 f = ray.origin - sphere.center, d = ray.direction;
    const rt::Vec3 moment = cross(f, d);
    const double a = dot(d, d), quarter = a * sphere.radius * sphere.radius - dot(moment, moment);
    const bool meets = quarter >= 0;
    const double nearest = -dot(f, d) / a, half_chord = meets ? std::sqrt(quarter) / a : 0;
    const Meetings right{2, nearest - half_chord, nearest + half_chord};

    out.disc(center, at.scale, thin(blue, meets ? 0.16 : 0.06));
    out.circle(center, at.scale, {meets ? blue : muted, 2});
    const Point start = at.to_page({start_x, c.height}),
                middle = at.to_page(in_plane(ray.at(nearest)));
    out.arrow(center, start, {pink, 2});
    out.text(0.55 * start + 0.45 * center + Point{0, 16}, "f", pink);
    draw_line(c, at, out);
    out.line(center, middle, {ink, 2});
    if (distance(center, middle) > 16) out.text(0.5 * (center + middle) + Point{-10, 0}, "p", ink);
    out.dot(center, ink, 3);
    out.text(center + Point{4, 16}, "C", ink);

    const auto place_of = [&](double t) { return at.to_page(in_plane(ray.at(t))); };
    if (meets) {
        const Point other = place_of(right.high);
        // The triangle of p, h and r, with its right angle.
        out.polygon({center, middle, other}, thin(amber, 0.15));
        out.line(center, other, {amber, 2});
        out.line(place_of(right.low), other, {blue, 4});
        const double half = distance(middle, other), away = distance(middle, center);
        if (half > 24 && away > 24) {
            const Point x = (10 / half) * (other - middle), y = (10 / away) * (center - middle);
            out.path({middle + x, middle + x + y, middle + y}, {ink, 1});
        }
        out.text(0.5 * (center + other) + Point{8, 12}, "r", amber);
        if (half > 12) out.text(0.5 * (middle + other) + Point{0, -12}, "h", blue);
    }

    const auto low = hit_sphere(sphere, ray, {-rt::infinity, rt::infinity});
    const auto above =
        low ? hit_sphere(sphere, ray, {std::nextafter(*low, rt::infinity), rt::infinity}) : low;
    const double high = above.value_or(low.value_or(0));
    if (low) {
        const Point one = place_of(*low), other = place_of(high);
        out.dot(one, blue, 6);
        out.dot(other, blue, 6);
        out.text(one + Point{-10, -16}, "low", blue, Align::right);
        out.text(other + Point{12, -16}, "high", blue, Align::left);
    }

    // The same in float: crosses at the points that it finds.
    const Meetings in_float = meetings_in_float(ray.origin.x, ray.origin.y, d.x, d.y);
    const Meetings textbook = textbook_meetings_in_float(ray.origin.x, ray.origin.y, d.x, d.y);
    if (!meets) {
        out.text(at.to_page({0, -1.25}), "D < 0: no solution", muted);
        out.say(low              ? "D = {+}: the line misses, but hit_sphere finds t = {.3}."
                : in_float.count ? "D = {+}: the line misses, but float says that it hits."
                                 : "D = {+}: the line passes {} beyond the surface.",
                4 * quarter, low.value_or(std::sqrt(dot(moment, moment) / a) - sphere.radius));
        return;
    }
    const auto cross_at = [&](double t, Ink color, double size) {
        const Point p = place_of(t);
        out.line(p + Point{-size, -size}, p + Point{size, size}, {color, 2.5});
        out.line(p + Point{-size, size}, p + Point{size, -size}, {color, 2.5});
    };
    for (const double t : {textbook.low, textbook.high})
        if (textbook.count) cross_at(t, orange, 6);
    for (const double t : {in_float.low, in_float.high})
        if (in_float.count) cross_at(t, green, 4);

    const auto say_error = [&](double y, Ink color, const Meetings& found, std::string_view off,
                               std::string_view miss) {
        out.text({12, y}, found.count ? off : miss, color, Align::left, found.low - right.low,
                 found.high - right.high);
    };
    if (out.is_narrow()) out.text_size = 11.5;
    say_error(out.height - 32, green, in_float, "× hit_sphere in float: off by {e}, {e}",
              "hit_sphere in float: a miss");
    say_error(out.height - 13, orange, textbook, "× textbook in float: off by {e}, {e}",
              "textbook in float: a miss");
    const double visible = 1e-3;  // of a radius
    if (!low)
        out.say("D = {+}, so the equation has two solutions, but hit_sphere finds none.",
                4 * quarter);
    else if (std::abs(*low - right.low) < visible && std::abs(high - right.high) < visible)
        out.say("D = {+}, so the equation has two solutions: low = {.3}, high = {.3}.", 4 * quarter,
                *low, high);
    else
        out.say("D = {+}, so low = {.3} and high = {.3}, but hit_sphere finds {.3} and {.3}.",
                4 * quarter, right.low, right.high, *low, high);
}

void drag(RootsControls& c, const Drag& to) {
    const Frame at = roots_frame(to.width);
    const Point start{start_x, c.height}, tip{tip_x, c.height + (tip_x - start_x) * c.slope};
    const double moved = -to.moved().y / at.scale;
    if (distance(at.to_page(start), to.down) < distance(at.to_page(tip), to.down)) {
        c.height += moved;  // the tip stays
        c.slope = (tip.y - std::clamp(c.height, -2.0, 2.0)) / (tip_x - start_x);
    } else {
        c.slope += moved / (tip_x - start_x);
    }
}

// ---- The nearest of many ----

namespace {

Frame nearest_frame(double width) {
    const double height = width * (width < 520 ? 0.5 : 0.42);
    return {{width / 2, height / 2}, {5, 0}, width / 10.4};
}

// In the order of the list, which is not the order of their distances.
const std::array<rt::SceneSphere, 5> row{{{{{5.2, 0.3, 0}, 0.9}, 0},
                                          {{{8.6, -0.2, 0}, 0.8}, 1},
                                          {{{3.0, -0.5, 0}, 0.7}, 2},
                                          {{{6.9, -0.8, 0}, 0.6}, 3},
                                          {{{1.7, 1.1, 0}, 0.5}, 4}}};
constexpr Ink row_inks[] = {blue, orange, green, pink, amber};

rt::Ray nearest_ray(const NearestControls& c) {
    const double angle = rt::radians(c.angle);
    return {{c.x, c.y, 0}, {std::cos(angle), std::sin(angle), 0}};
}

constexpr double tip_t = 1.2;  // where the ray's arrow head is

}  // namespace

void draw(const NearestControls& c, Drawing& out) {
    const Frame at = nearest_frame(out.width);
    const double list_height = out.is_narrow() ? 62 : 48;
    out.height = 2 * at.at.y + list_height;
    const rt::Ray ray = nearest_ray(c);
    const auto tried = static_cast<std::size_t>(c.tried);
    const std::span spheres{row};
    const auto nearest = rt::nearest_sphere(spheres.first(tried), ray, {0, rt::infinity});

    for (std::size_t i = 0; i < row.size(); ++i) {
        const rt::Sphere& sphere = row[i].shape;
        const Point center = at.to_page(in_plane(sphere.center));
        const double radius = at.scale * sphere.radius;
        const bool is_nearest = nearest && nearest->number == i;
        out.disc(center, radius, thin(row_inks[i], i < tried ? is_nearest ? 0.55 : 0.22 : 0.07));
        out.circle(center, radius,
                   {thin(row_inks[i], i < tried ? 1 : 0.5), is_nearest ? 4.0 : 1.5,
                    i < tried ? 0.0 : 4.0});
        out.bold = true;
        out.text(center + Point{0, 0.55 * radius}, "{}", row_inks[i], Align::middle, double(i));
        out.bold = false;
    }

    // The part of the ray on which a hit still counts.
    const double end = nearest ? nearest->t : 12;
    const Point start = at.to_page(in_plane(ray.origin)), tip = at.to_page(in_plane(ray.at(tip_t)));
    out.line(start, at.to_page(in_plane(ray.at(12))), {muted, 1.5, 5});
    out.line(start, at.to_page(in_plane(ray.at(end))), {accent, 3.5});
    out.arrow(start, tip, {accent, 3.5});
    if (nearest) out.dot(at.to_page(in_plane(ray.at(end))), row_inks[nearest->number], 6);
    out.handle(start);
    out.handle(tip);

    // The list, with the result of each test.
    const double cell = out.width / row.size(), top = 2 * at.at.y + 4;
    if (out.is_narrow()) out.text_size = 11.5;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const Point corner{cell * static_cast<double>(i) + 3, top};
        const Point opposite{corner.x + cell - 6, top + list_height - 8};
        const Point middle = 0.5 * (corner + opposite), above = middle + Point{0, -10},
                    below = middle + Point{0, 10};
        out.box(corner, opposite, thin(row_inks[i], i < tried ? 0.18 : 0.05));
        out.text(above, i < tried || out.is_narrow() ? "{}" : "sphere {}", row_inks[i],
                 Align::middle, double(i));
        if (i >= tried) continue;
        const auto before = rt::nearest_sphere(spheres.first(i), ray, {0, rt::infinity});
        const auto t = rt::hit_sphere(row[i].shape, ray, {0, rt::infinity});
        if (!t)
            out.text(below, "a miss", muted);
        else if (before && *t > before->t)
            out.text(below, out.is_narrow() ? "{.2} too far" : "t = {.2}: too far", muted,
                     Align::middle, *t);
        else
            out.text(below, "t = {.2}", ink, Align::middle, *t);
    }
    if (nearest)
        out.say(
            "After {} of 5: sphere {} is the nearest. From now on, only hits up to t = {.2} "
            "count.",
            c.tried, double(nearest->number), nearest->t);
    else
        out.say("After {} of 5: no hit yet. Any hit ahead counts.", c.tried);
}

void drag(NearestControls& c, const Drag& to) {
    const Frame at = nearest_frame(to.width);
    const rt::Ray ray = nearest_ray(c);
    const Point start = at.to_page(in_plane(ray.origin)), tip = at.to_page(in_plane(ray.at(tip_t)));
    if (distance(start, to.down) < distance(tip, to.down)) {
        const Point now = at.to_plane(start + to.moved());
        c.x = now.x, c.y = now.y;
    } else {
        const Point along = at.to_plane(tip + to.moved()) - in_plane(ray.origin);
        c.angle = in_degrees(std::atan2(along.y, along.x));
    }
}

// ---- Light and bytes ----

// A gray between stripes of black and white that are so thin that the eye sees their mean.
void draw(const BytesControls& c, Drawing& out) {
    const int white = 1 + static_cast<int>(c.light);  // of four rows
    const int rows = static_cast<int>(std::round(0.28 * out.width * out.pixel_ratio));
    out.height = rows / out.pixel_ratio;
    Bytes& stripes = out.picture(1, rows);
    for (int row = 0; row < rows; ++row)
        stripes.set(0, row, row * white % 4 < white ? rt::Color{1, 1, 1} : rt::Color{});
    out.show(stripes, {0, 0}, {out.width, out.height}, false);
    const std::uint32_t gray = 0x010101 * static_cast<std::uint32_t>(c.byte);
    out.box({0.3 * out.width, 0}, {0.7 * out.width, out.height}, rgb(gray));
    out.say("The stripes send {.2} of full light. A byte of {} stands for {.2}.", 0.25 * white,
            c.byte, rt::from_hex(gray).r);
    out.handle_everywhere();
}

// To the right, brighter.
void drag(BytesControls& c, const Drag& to) {
    c.byte = std::round(c.byte + 255 * to.moved().x / to.width);
}

}  // namespace live
