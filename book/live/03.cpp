// The live figures of chapter 03.
#include <rt/cross.hpp>
#include <rt/hit_sphere.hpp>

#include "03.float.hpp"
#include "controls.hpp"
#include "live.hpp"

namespace live {
namespace {

// ---- A ray and a sphere ----

constexpr double start_x = -4, tip_x = 2.3;  // where the ray's ends are in the figure

Frame roots_frame(double width) {
    const double scale = width / 7.4;
    return {{0.5 * width, (width < 520 ? 0.32 : 0.25) * width}, {-0.85, 0}, scale};
}

// The ray as it is: it starts at the distance that was asked for, on the line that one sees.
rt::Ray far_ray(const RootsControls& c) {
    const rt::Vec3 d{1, c.slope, 0};
    const double back = std::pow(10, c.far) + start_x;
    return {rt::Vec3{start_x, c.height, 0} - back * d, d};
}

Point in_plane(rt::Vec3 p) {
    return {p.x, p.y};
}

void draw_line(const RootsControls& c, const Frame& at, Drawing& out) {
    const Point start = at.to_page({start_x, c.height}),
                tip = at.to_page({tip_x, c.height + (tip_x - start_x) * c.slope});
    out.arrow(start, tip, {accent, 2.5});
    if (c.far > 0.66) {  // a gap: the ray starts far to the left
        const Point cut = start + 0.1 * (tip - start);
        for (const double side : {-4.0, 4.0})
            out.line(cut + Point{side - 4, 9}, cut + Point{side + 4, -9}, {muted, 1.5});
        out.text(start + Point{0, 26}, "{} radii away", muted, Align::left, std::pow(10, c.far));
    }
    out.handle(start);
    out.handle(tip);
    out.text(start + Point{0, -24}, "O", ink);
    out.text(tip + Point{2, -22}, "d", accent);
}

}  // namespace

void draw(const RootsControls& c, Drawing& out) {
    const Frame at = roots_frame(out.width);
    out.height = 2 * at.at.y;
    const rt::Ray ray = far_ray(c);
    const rt::Sphere sphere{{0, 0, 0}, 1};
    const Point center = at.to_page({0, 0});

    // Half of the chord h, the distance p of the line from the center, and the discriminant.
    const rt::Vec3 f = ray.origin - sphere.center, d = ray.direction;
    const rt::Vec3 moment = cross(f, d);
    const double a = dot(d, d), quarter = a * sphere.radius * sphere.radius - dot(moment, moment);
    const Point foot = in_plane(ray.at(-dot(f, d) / a));

    out.disc(center, at.scale, thin(blue, quarter >= 0 ? 0.16 : 0.06));
    out.circle(center, at.scale, {quarter >= 0 ? blue : muted, 2});
    draw_line(c, at, out);
    out.line(center, at.to_page(foot), {muted, 1.5, 4});
    out.text(center + 0.5 * (at.to_page(foot) - center) + Point{12, 0}, "p", muted);
    out.dot(center, ink, 3);
    out.text(center + Point{-12, 10}, "C", ink);

    const auto low = hit_sphere(sphere, ray, {-rt::infinity, rt::infinity});
    if (!low) {
        out.text(at.to_page({0, -1.25}), "D < 0: no solution", muted);
        const Meetings wrong = meetings_in_float(ray.origin.x, ray.origin.y, d.x, d.y);
        out.say(wrong.count ? "D/4 = {+}: the line misses, but float says that it hits."
                            : "D/4 = {+}: the line passes {} beyond the surface.",
                quarter, wrong.count ? 0 : std::sqrt(dot(moment, moment) / a) - sphere.radius);
        return;
    }
    const auto above = hit_sphere(sphere, ray, {std::nextafter(*low, rt::infinity), rt::infinity});
    const double high = above.value_or(*low);
    const Point one = at.to_page(in_plane(ray.at(*low))),
                other = at.to_page(in_plane(ray.at(high)));
    out.line(one, other, {blue, 4});
    out.text(0.5 * (at.to_page(foot) + other) + Point{0, -12}, "h", blue);
    out.dot(one, blue, 6);
    out.dot(other, blue, 6);
    out.text(one + Point{-10, 16}, "t₁", blue, Align::right);
    out.text(other + Point{12, 16}, "t₂", blue, Align::left);

    // The same in float: crosses where it lands.
    const Meetings in_float = meetings_in_float(ray.origin.x, ray.origin.y, d.x, d.y);
    const Meetings textbook = textbook_meetings_in_float(ray.origin.x, ray.origin.y, d.x, d.y);
    const auto cross_at = [&](double t, Ink color, double size) {
        const Point p = at.to_page(in_plane(ray.at(t)));
        out.line(p + Point{-size, -size}, p + Point{size, size}, {color, 2.5});
        out.line(p + Point{-size, size}, p + Point{size, -size}, {color, 2.5});
    };
    for (const double t : {textbook.low, textbook.high})
        if (textbook.count) cross_at(t, orange, 6);
    for (const double t : {in_float.low, in_float.high})
        if (in_float.count) cross_at(t, green, 4);

    out.text({12, out.height - 34},
             in_float.count ? "× float, this chapter's formula: off by {e} and {e}"
                            : "float, this chapter's formula: a miss",
             green, Align::left, in_float.low - *low, in_float.high - high);
    out.text({12, out.height - 14},
             textbook.count ? "× float, textbook's formula: off by {e} and {e}"
                            : "float, textbook's formula: a miss",
             orange, Align::left, textbook.low - *low, textbook.high - high);
    out.say("D/4 = {+}, so the line meets the sphere twice: t₁ = {}, t₂ = {}.", quarter, *low,
            high);
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

}  // namespace live
