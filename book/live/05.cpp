// The live figures of chapter 05.
#include <rt/make_camera.hpp>
#include <rt/render_pixel.hpp>

#include "controls.hpp"
#include "live.hpp"
#include "plane.hpp"
#include "scene.hpp"

namespace live {
namespace {

// ---- The chapter's scene ----

using Materials =
    rt::MaterialSet<rt::Lambertian, scene::Tiles, rt::Metal, rt::Dielectric, rt::SchlickDielectric>;

// The scene's materials, with what the controls change.
Materials materials_of(const scene::Scene& evening, const SceneControls& c) {
    Materials changed;
    for (const auto& one : evening.set.materials) {
        auto material = std::visit(
            [](const auto& same) -> decltype(changed.materials)::value_type { return same; }, one);
        if (auto* metal = std::get_if<rt::Metal>(&material))
            metal->fuzz = std::clamp(metal->fuzz + c.fuzz, 0.0, 1.0);
        if (const auto* glass = std::get_if<rt::Dielectric>(&material)) {
            const double index = glass->index > 1 ? c.index : 1 / c.index;  // a bubble's is below 1
            if (c.reflectance > 0)
                material = rt::SchlickDielectric{index};
            else
                material = rt::Dielectric{index};
        }
        changed.materials.push_back(material);
    }
    return changed;
}

}  // namespace

void draw(const SceneControls& c, Drawing& out) {
    const double aspect = out.is_narrow() ? 1.7 : 2.2;
    out.height = out.width / aspect;
    const int columns = static_cast<int>(std::min(out.width * out.pixel_ratio, 560.0)),
              rows = static_cast<int>(columns / aspect);
    const double turn = rt::radians(c.turn), width = 2.46 * std::tan(rt::radians(9.5));
    const rt::Camera camera = rt::make_camera({{12 * std::sin(turn), 2.9, 12 * std::cos(turn)},
                                               {0, 0.85, 0},
                                               {0, 1, 0},
                                               2 * std::atan(width / aspect)},
                                              columns, rows);
    const scene::Scene evening = scene::evening();
    out.refine({0, 0}, {out.width, out.height}, columns, rows, 256,
               [camera, world = evening.world, set = materials_of(evening, c),
                depth = static_cast<int>(c.depth)](int column, int row, int sample) {
                   rt::Rng random = rt::pixel_rng(static_cast<unsigned>(sample), column, row);
                   return path_radiance(primary_ray(camera, column, row, random_place(random)),
                                        world, set, scene::EveningSky{}, rt::SkyEnding{}, depth,
                                        random);
               });
    out.handle_everywhere();
    const double glass = rt::fresnel_reflectance(1, 1 / c.index);
    out.say("Head on, glass of index {} reflects {.1} % of the light.", c.index, 100 * glass);
}

void drag(SceneControls& c, const Drag& to) {
    c.turn -= 90 * to.moved().x / to.width;
}

// ---- A beam at a surface of glass ----

namespace {

// Where the beam meets the surface, and the plot beside it or below it.
struct RaysLayout {
    Frame beams;  // a unit is the length of a beam
    Point plot_corner, plot_opposite;
    double height;
};

RaysLayout rays_layout(double width) {
    if (width < 520) {
        const double half = 0.43 * width;
        return {{{width / 2, half + 8}, {}, half - 8},
                {48, 2 * half + 50},
                {width - 14, 2 * half + 220},
                2 * half + 256};
    }
    const double height = 0.5 * width, half = height / 2;
    return {{{0.295 * width, half}, {}, half - 12},
            {0.66 * width, 46},
            {width - 18, height - 50},
            height};
}

// Light at the surface y = 0: the half of the plane below is glass.
struct Meeting {
    rt::Vec3 incoming, normal, reflected;
    std::optional<rt::Vec3> refracted;
    double cosine, eta, reflectance;
};

Meeting meeting_of(const RaysControls& c, double degrees) {
    const double angle = rt::radians(degrees), side = c.inside > 0 ? -1 : 1;
    const double sine = std::sin(angle), cosine = std::cos(angle);
    const rt::Vec3 incoming{sine, -side * cosine, 0}, normal{0, side, 0};
    const double eta = c.inside > 0 ? c.index : 1 / c.index;
    return {incoming, normal, reflect(incoming, normal),           refract(incoming, normal, eta),
            cosine,   eta,    rt::fresnel_reflectance(cosine, eta)};
}

// Part of a beam: it runs along `d` through the origin, from `begin` to `end`, and the surface cuts
// it off on the side of y that `side` gives the sign of. Its wave fronts are `wave` apart. The more
// of the light it carries, the stronger it is drawn.
struct Beam {
    rt::Vec3 d;
    double begin, end, width, side, wave, share;
    Ink color;
};

void draw_beam(Drawing& out, const Frame& at, const Beam& beam) {
    const Point d = in_plane(beam.d), across{-d.y, d.x};
    const double half = beam.width / 2, strength = 0.16 + 0.84 * beam.share;
    // Where its two edges meet the surface, along the beam.
    const auto cut = [&](double offset) { return -offset * across.y / d.y; };
    const bool arrives = beam.end <= 0;
    const auto corner = [&](double offset, bool at_surface) {
        const double along = at_surface ? cut(offset) : arrives ? beam.begin : beam.end;
        return at.to_page(along * d + offset * across);
    };
    out.polygon(
        {corner(-half, true), corner(half, true), corner(half, false), corner(-half, false)},
        thin(beam.color, 0.5 * strength));
    const auto is_here = [&](Point p) { return p.y * beam.side >= 0; };
    for (int front = -60; front <= 60; ++front) {
        const double along = front * beam.wave;
        if (along < beam.begin || along > beam.end) {
            if (std::abs(along) > half + 1) continue;
            if (arrives ? along < beam.begin : along > beam.end) continue;
        }
        Point one = along * d - half * across, other = along * d + half * across;
        if (!is_here(one) && !is_here(other)) continue;
        if (is_here(one) != is_here(other)) {  // the surface cuts it
            const Point meets = one + (one.y / (one.y - other.y)) * (other - one);
            (is_here(one) ? other : one) = meets;
        }
        out.line(at.to_page(one), at.to_page(other), {thin(beam.color, 0.9 * strength), 1.5});
    }
    out.arrow(at.to_page(beam.begin * d), at.to_page(beam.end * d),
              {thin(beam.color, 0.25 + 0.75 * beam.share), 1.5 + 3 * beam.share});
}

// The angle between the normal, on the side of `side`, and a ray on the side of the x axis.
void draw_angle(Drawing& out, const Frame& at, double radius, double degrees, double x_side,
                double side, Ink color) {
    const double normal = side * rt::pi / 2;
    draw_arc(out, at.to_page({}), radius * at.scale, normal,
             normal - side * x_side * rt::radians(degrees), {color, 2});
    const double middle = rt::radians(std::max(degrees / 2, 9.0)), far = radius + 24 / at.scale;
    out.bold = true;
    out.text(at.to_page({x_side * far * std::sin(middle), side * far * std::cos(middle)}), "{.1}°",
             color, Align::middle, degrees);
    out.bold = false;
}

void draw_reflectance(const RaysControls& c, const Meeting& now, const RaysLayout& layout,
                      Drawing& out) {
    const Point low{layout.plot_corner.x, layout.plot_opposite.y}, high = layout.plot_opposite;
    const auto place = [&](double degrees, double share) {
        return Point{low.x + (high.x - low.x) * degrees / 90,
                     low.y + (layout.plot_corner.y - low.y) * share};
    };
    out.text(place(0, 1) + Point{-30, -24}, "Share that is reflected", ink, Align::left);
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        out.line(place(0, share), place(90, share), {faint, 1});
        out.text(place(0, share) + Point{-8, 0}, "{} %", muted, Align::right, 100 * share);
    }
    for (const double degrees : {0.0, 30.0, 60.0, 90.0}) {
        out.line(place(degrees, 0), place(degrees, 0) + Point{0, 5}, {muted, 1});
        out.text(place(degrees, 0) + Point{0, 17}, "{}°", muted, Align::middle, degrees);
    }
    std::vector<Point> exact, schlick, below;
    for (int i = 0; i <= 360; ++i) {
        const double degrees = 0.25 * i, cosine = std::cos(rt::radians(degrees));
        exact.push_back(place(degrees, rt::fresnel_reflectance(cosine, now.eta)));
        schlick.push_back(place(degrees, rt::schlick_reflectance(cosine, now.eta)));
    }
    below = exact;
    below.push_back(place(90, 0)), below.push_back(place(0, 0));
    out.polygon(below, thin(pink, 0.14));
    out.path(schlick, {muted, 1.5, 4});
    out.path(exact, {pink, 2.5});
    const Point dot = place(c.angle, now.reflectance);
    out.line(place(c.angle, 0), dot, {pink, 1, 3});
    out.handle(dot);
    out.dot(dot, pink, 5);
    out.text_size = 12;
    out.text(place(4, 0.92), "exact", pink, Align::left);
    out.text(place(4, 0.83), "Schlick, dashed", muted, Align::left);
    out.text_size = 13;
}

}  // namespace

void draw(const RaysControls& c, Drawing& out) {
    const RaysLayout layout = rays_layout(out.width);
    const Frame& at = layout.beams;
    out.height = layout.height;
    const Meeting now = meeting_of(c, c.angle);
    const bool inside = c.inside > 0;
    const double side = now.normal.y, wide = at.at.x - 6, reach = at.scale + 6;

    out.box(at.at + Point{-wide, 0}, at.at + Point{wide, reach}, thin(sky, 0.16));
    out.line(at.at + Point{-wide, 0}, at.at + Point{wide, 0}, {sky, 2.5});
    out.line(at.to_page({0, -1}), at.to_page({0, 1}), {muted, 1.2, 5});
    out.text(at.at + Point{wide - 6, -14}, "air", muted, Align::right);
    out.text(at.at + Point{wide - 6, 14}, "glass, index {.2}", muted, Align::right, c.index);
    const double sine = now.eta * std::sin(rt::radians(c.angle));
    out.text(at.at + Point{6 - wide, 14 * side},
             now.refracted ? "{.2} · sin {.1}° = {.2}" : "{.2} · sin {.1}° = {.2} > 1", muted,
             Align::left, now.eta, c.angle, sine);

    // Its footprint on the surface must fit the drawing.
    const double width = std::min(0.36, 1.1 * now.cosine), wave = 0.085;
    const double critical = in_degrees(std::asin(1 / c.index));
    if (inside && c.index > 1) {
        const double a = rt::radians(critical);
        out.line(at.to_page({-std::sin(a), -std::cos(a)}), at.to_page({}), {muted, 1.2, 2});
    }
    const double ahead = inside ? wave / c.index : wave, behind = inside ? wave : wave / c.index;
    if (now.refracted) {
        const double narrowed = std::abs(now.refracted->y) / now.cosine;
        draw_beam(
            out, at,
            {*now.refracted, 0, 0.95, width * narrowed, -side, behind, 1 - now.reflectance, blue});
    }
    draw_beam(out, at, {now.reflected, 0, 0.95, width, side, ahead, now.reflectance, pink});
    draw_beam(out, at, {now.incoming, -0.93, 0, width, side, ahead, 1, amber});
    draw_angle(out, at, 0.38, c.angle, -1, side, ink);
    if (now.refracted) {
        const double beyond = in_degrees(std::atan2(now.refracted->x, std::abs(now.refracted->y)));
        draw_angle(out, at, 0.38, beyond, 1, -side, ink);
        out.say(inside
                    ? "At {.1}° inside, the light gets out at {.1}°: {.1} % is reflected, {.1} % "
                      "goes through. By Schlick, {.1} % would be reflected."
                    : "At {.1}° in air, the light goes on at {.1}° inside: {.1} % is reflected, "
                      "{.1} % goes through. By Schlick, {.1} % would be reflected.",
                c.angle, beyond, 100 * now.reflectance, 100 * (1 - now.reflectance),
                100 * rt::schlick_reflectance(now.cosine, now.eta));
    } else {
        out.bold = true;
        out.text(at.to_page({0, 0.5}), "total reflection", pink);
        out.bold = false;
        out.say("Beyond the critical angle, here {.1}°, no light gets out: all of it is reflected.",
                critical);
    }
    out.handle(at.to_page(in_plane(-0.93 * now.incoming)), 24);
    draw_reflectance(c, now, layout, out);
}

void drag(RaysControls& c, const Drag& to) {
    const RaysLayout layout = rays_layout(to.width);
    const Frame& at = layout.beams;
    const Meeting then = meeting_of(c, c.angle);
    const Point lamp = at.to_page(in_plane(-0.93 * then.incoming));
    if (distance(to.down, lamp) < 45) {
        const Point p = at.to_plane(lamp + to.moved());
        c.inside = p.y < 0 ? 1 : 0;
        c.angle = in_degrees(std::atan2(std::max(0.0, -p.x), std::abs(p.y)));
    } else {
        c.angle += 90 * to.moved().x / (layout.plot_opposite.x - layout.plot_corner.x);
    }
    c.angle = std::min(c.angle, 89.5);
}

}  // namespace live
