// The live figures of chapter 04.
#include <rt/hit_sphere.hpp>
#include <rt/lambert.hpp>
#include <rt/make_camera.hpp>
#include <rt/render_pixel.hpp>

#include "04.float.hpp"
#include "controls.hpp"
#include "live.hpp"
#include "plane.hpp"
#include "scene.hpp"
#include "space.hpp"

namespace live {
namespace {

// ---- Samples of a pixel ----

struct SamplesLayout {
    Point corner;  // of the picture
    double width, height;
    Point zoom;  // the corner of the enlarged pixel
    double side, page;
};

SamplesLayout samples_layout(double width) {
    if (width < 520) {
        const double side = 0.62 * width;
        return {{0, 0},       width,
                0.68 * width, {(width - side) / 2, 0.68 * width + 30},
                side,         0.68 * width + side + 40};
    }
    const double height = 0.44 * width, side = 0.9 * height - 24;
    return {{0, 0}, width - side - 30, height, {width - side - 4, (height - side) / 2 + 8}, side,
            height};
}

// The picture's plane is 4 units wide; a unit is so many pixels of the page.
double unit_of(const SamplesLayout& layout) {
    return layout.width / 4;
}

struct Sampler {
    SamplesControls c;
    rt::Camera camera;

    // The light at a point of a pixel.
    double light(int column, int row, rt::Vec2 offset) const {
        const rt::Ray ray = primary_ray(camera, column, row, offset);
        if (c.subject == 0) {
            const rt::Sphere ball{{c.x, c.y, 0}, 0.85};
            const auto t = rt::hit_sphere(ball, ray, {0, rt::infinity});
            if (!t) return 0.03;
            return 0.25 +
                   0.75 * lambert(surface_hit(ball, ray, *t).normal, rt::normalize({-1, 2, 2}));
        }
        const rt::Vec3 p = ray.at(-ray.origin.z / ray.direction.z);
        const double r_squared = (p.x - c.x) * (p.x - c.x) + (p.y - c.y) * (p.y - c.y);
        return 0.5 + 0.5 * std::cos(40 * r_squared);
    }

    // The average over a pixel with the chosen pattern. Calls visit(offset, light) for each sample.
    template <class Visit>
    double average(int column, int row, Visit visit) const {
        const int count = static_cast<int>(c.samples);
        rt::Rng random = rt::pixel_rng(1, column, row);
        double sum = 0;
        int used = 0;
        const auto take = [&](rt::Vec2 offset) {
            const double value = light(column, row, offset);
            visit(offset, value);
            sum += value, ++used;
            return rt::Color{value, value, value};
        };
        if (c.pattern == 2) {
            rt::pixel_average(count, random, take);
        } else if (c.pattern == 1) {
            for (int i = 0; i < count; ++i) take(random_place(random));
        } else {
            const int n = static_cast<int>(std::sqrt(count));
            for (int i = 0; i < n * n; ++i) take(rt::jittered_offset(i, n, {0.5, 0.5}));
        }
        return sum / used;
    }

    // As good as exact: many samples in the middles of cells.
    double exact(int column, int row, int n) const {
        double sum = 0;
        for (int i = 0; i < n * n; ++i)
            sum += light(column, row, rt::jittered_offset(i, n, {0.5, 0.5}));
        return sum / (n * n);
    }
};

struct Pixel {
    int column, row;
};
Pixel chosen(const SamplesControls& c, int columns, int rows) {
    return {std::min(static_cast<int>(c.column * columns), columns - 1),
            std::min(static_cast<int>(c.row * rows), rows - 1)};
}

}  // namespace

void draw(const SamplesControls& c, Drawing& out) {
    const SamplesLayout layout = samples_layout(out.width);
    out.height = layout.page;
    const int columns = static_cast<int>(c.pixels),
              rows = static_cast<int>(columns * layout.height / layout.width);
    // From afar, so that a unit of the plane z = 0 is equally long everywhere in the picture.
    const double plane_height = 4 * rows / static_cast<double>(columns);
    const rt::Camera camera = rt::make_camera(
        {{0, 0, 50}, {0, 0, 0}, {0, 1, 0}, 2 * std::atan(plane_height / 2 / 50)}, columns, rows);
    const Sampler sampler{c, camera};
    const auto gray = [](double light) {
        return rt::mix({0.02, 0.03, 0.06}, {1, 0.93, 0.8}, light);
    };

    Bytes& picture = out.picture(columns, rows);
    double squares = 0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double value = sampler.average(column, row, [](rt::Vec2, double) {});
            picture.set(column, row, gray(value));
            const double error = value - sampler.exact(column, row, 8);
            squares += error * error;
        }
    const double pixel = layout.width / columns;
    const Point corner = layout.corner, opposite = corner + Point{layout.width, pixel * rows};
    out.show(picture, corner, opposite, false);

    const Pixel one = chosen(c, columns, rows);
    const Point from = corner + pixel * Point{double(one.column), double(one.row)},
                to = from + Point{pixel, pixel};
    const Point zoom = layout.zoom, zoom_end = zoom + Point{layout.side, layout.side};
    // The pixel, enlarged: what is really in it, and where the samples are.
    constexpr int fine = 96;
    Bytes& inside = out.picture(fine, fine);
    for (int y = 0; y < fine; ++y)
        for (int x = 0; x < fine; ++x)
            inside.set(
                x, y,
                gray(sampler.light(one.column, one.row, {(x + 0.5) / fine, (y + 0.5) / fine})));
    out.show(inside, zoom, zoom_end);
    if (c.pattern != 1) {
        const int n = static_cast<int>(std::sqrt(c.samples));
        for (int i = 1; i < n; ++i) {
            const double at = layout.side * i / n;
            out.line(zoom + Point{at, 0}, zoom + Point{at, layout.side},
                     {thin(rgb(0x6ea8ff), 0.5), 1});
            out.line(zoom + Point{0, at}, zoom + Point{layout.side, at},
                     {thin(rgb(0x6ea8ff), 0.5), 1});
        }
    }
    const double value = sampler.average(one.column, one.row, [&](rt::Vec2 offset, double light) {
        const Point at = zoom + layout.side * Point{offset.x, offset.y};
        out.disc(at, 5.5, rgb(0xff7a1a));
        out.disc(at, 3.5, shown(gray(light)));
    });
    out.frame(zoom, zoom_end, {amber, 3});
    out.frame(from, to, {amber, 3});
    if (!out.is_narrow()) {
        out.line({to.x, from.y}, zoom, {thin(amber, 0.6), 1});
        out.line(to, {zoom.x, zoom_end.y}, {thin(amber, 0.6), 1});
    }
    const Point words{(zoom.x + zoom_end.x) / 2, zoom.y - 14};
    out.text(words, "column {}, row {}", muted, Align::middle, double(one.column), double(one.row));

    const Point ball = corner + Point{layout.width / 2 + unit_of(layout) * c.x,
                                      pixel * rows / 2 - unit_of(layout) * c.y};
    out.handle(ball);
    out.handle(0.5 * (from + to), 0.5 * std::hypot(layout.width, layout.height), false);
    out.say("This pixel: {.3}; exact: {.3}. Root mean square of all pixels’ errors: {.4}.", value,
            sampler.exact(one.column, one.row, 32), std::sqrt(squares / (columns * rows)));
}

void drag(SamplesControls& c, const Drag& to) {
    const SamplesLayout layout = samples_layout(to.width);
    const int columns = static_cast<int>(c.pixels),
              rows = static_cast<int>(columns * layout.height / layout.width);
    const double height = layout.width / columns * rows, unit = unit_of(layout);
    const Point ball =
        layout.corner + Point{layout.width / 2 + unit * c.x, height / 2 - unit * c.y};
    if (distance(ball, to.down) < 24) {
        c.x += to.moved().x / unit;
        c.y -= to.moved().y / unit;
    } else {
        c.column = (to.at.x - layout.corner.x) / layout.width;
        c.row = (to.at.y - layout.corner.y) / height;
    }
}

// ---- Random directions ----

namespace {

struct DirectionsLayout {
    Point middle;  // of the hemisphere
    double radius;
    Point corner, opposite;  // of the bars
    double height;
};

DirectionsLayout directions_layout(double width) {
    if (width < 520)
        return {{width / 2, 0.52 * width},
                0.38 * width,
                {34, 0.84 * width},
                {width - 10, 1.24 * width},
                1.24 * width + 40};
    return {{0.27 * width, 0.28 * width},
            0.21 * width,
            {0.6 * width, 0.07 * width},
            {width - 12, 0.37 * width},
            0.37 * width + 44};
}

}  // namespace

void draw(const DirectionsControls& c, Drawing& out) {
    const DirectionsLayout layout = directions_layout(out.width);
    out.height = layout.height;
    const Space space{layout.middle, {0, 0, 0}, c.turn, c.up, layout.radius};
    const rt::Vec3 normal{0, 1, 0};
    const int count = static_cast<int>(std::lround(std::pow(10, c.count)));
    const Ink color = c.way == 0 ? blue : orange;

    const auto ring = [&](double height, Pen pen) {
        std::vector<Point> points;
        const double radius = std::sqrt(1 - height * height);
        for (int i = 0; i <= 72; ++i) {
            const double angle = rt::radians(5 * i);
            points.push_back(
                space.to_page({radius * std::cos(angle), height, radius * std::sin(angle)}));
        }
        if (height == 0) out.polygon(points, thin(color, 0.08));
        out.path(points, pen);
    };
    ring(0, {ink, 1.5});
    for (const double height : {0.25, 0.5, 0.75}) ring(height, {thin(muted, 0.5), 0.8});
    for (int i = 0; i < 6; ++i) {
        std::vector<Point> arc;
        const double turn = rt::radians(30 * i);
        for (int k = 0; k <= 36; ++k) {
            const double angle = rt::radians(5 * k);
            arc.push_back(space.to_page({std::cos(angle) * std::cos(turn), std::sin(angle),
                                         std::cos(angle) * std::sin(turn)}));
        }
        out.path(arc, {thin(muted, 0.35), 0.8});
    }

    rt::Rng random{7, 4};
    constexpr int bars = 10;
    std::array<int, bars> found{};
    std::vector<rt::Vec3> directions;
    double cosines = 0;
    for (int i = 0; i < count; ++i) {
        const rt::Vec2 place = random_place(random);
        const double radius = std::sqrt(1 - place.x * place.x), angle = 2 * rt::pi * place.y;
        const rt::Vec3 d =
            c.way == 0 ? rt::cosine_direction(normal, place)
                       : rt::Vec3{radius * std::cos(angle), place.x, radius * std::sin(angle)};
        directions.push_back(d);
        const double cosine = rt::dot(d, normal);
        cosines += cosine;
        ++found[static_cast<std::size_t>(std::min(bars - 1, static_cast<int>(bars * cosine)))];
    }
    const double size = count > 600 ? 1.5 : 2.6;
    for (const rt::Vec3 d : directions) {  // the shadows on the disk first
        if (count < 40)
            out.line(space.to_page(d), space.to_page({d.x, 0, d.z}), {thin(muted, 0.6), 1, 3});
        out.disc(space.to_page({d.x, 0, d.z}), 0.8 * size, thin(muted, 0.7));
    }
    for (const bool is_front : {false, true})
        for (const rt::Vec3 d : directions)
            if ((space.toward(d) > 0) == is_front) {
                if (count < 40)
                    out.line(space.to_page({}), space.to_page(d), {thin(color, 0.6), 1.2});
                out.disc(space.to_page(d), size, thin(color, is_front ? 1 : 0.55));
            }
    out.arrow(space.to_page({}), space.to_page({0, 1.22, 0}), {ink, 2.5});
    out.bold = true;
    out.text(space.to_page({0, 1.22, 0}) + Point{14, 0}, "n", ink);
    out.bold = false;
    out.handle_everywhere();

    // How often each cosine occurs, and what is expected.
    const Point corner = layout.corner, opposite = layout.opposite;
    const double width = opposite.x - corner.x, height = opposite.y - corner.y;
    const auto at = [&](double cosine, double density) {
        return Point{corner.x + width * cosine, opposite.y - height * density / 2.4};
    };
    for (int i = 0; i < bars; ++i) {
        const double share = static_cast<double>(found[static_cast<std::size_t>(i)]) / count;
        out.box(at((i + 0.08) / bars, 0), at((i + 0.92) / bars, bars * share), thin(color, 0.6));
    }
    out.line(at(0, 0), at(1, 0), {muted, 1.2});
    for (const double mark : {0.0, 0.5, 1.0})
        out.text(at(mark, 0) + Point{0, 12}, "{.1}", muted, Align::middle, mark);
    out.text({(corner.x + opposite.x) / 2, opposite.y + 30}, "cosine of the angle to the normal",
             muted);
    for (const double density : {1.0, 2.0}) {
        out.line(at(0, density), at(1, density), {faint, 1});
        out.text(at(0, density) + Point{-8, 0}, "{}", muted, Align::right, density);
    }
    out.line(at(0, c.way == 0 ? 0 : 1), at(1, c.way == 0 ? 2 : 1), {ink, 2, 5});
    out.text(at(0.02, 2.3), "density", muted, Align::left);
    out.say("{} directions; the mean of their cosines is {.3}, the expected mean {.3}.",
            double(count), cosines / count, c.way == 0 ? 2.0 / 3 : 0.5);
}

void drag(DirectionsControls& c, const Drag& to) {
    c.turn -= 240 * to.moved().x / to.width;
    c.up += 200 * to.moved().y / to.width;
}

// ---- Leaving a surface ----

namespace {

struct LeaveLayout {
    double left, right, surface, height;  // where the surface is, from above
};

LeaveLayout leave_layout(double width) {
    const double height = width < 520 ? 0.95 * width : 0.5 * width;
    return {8, width - 8, 0.55 * height, height};
}

constexpr double arrow_length = 56;

}  // namespace

void draw(const LeaveControls& c, Drawing& out) {
    const LeaveLayout layout = leave_layout(out.width);
    out.height = layout.height;
    constexpr int count = 61;
    const double radius = std::pow(10, c.radius), far = radius * std::pow(10, c.far);
    std::vector<Departure> all;
    double bound = 0, reach = 0;  // the largest of their error bounds, and of all heights
    int wrong = 0;
    for (int i = 0; i < count; ++i) {
        // A thousandth of a degree apart: each is rounded in its own way.
        all.push_back(depart_in_float(radius, far, rt::radians(c.place + 0.001 * (i - count / 2)),
                                      rt::radians(c.angle), static_cast<int>(c.way)));
        bound = std::max(bound, all.back().error);
        reach = std::max(
            {reach, all.back().error, std::abs(all.back().height), std::abs(all.back().start)});
        wrong += !all.back().is_right;
    }

    const double scale = 0.29 * layout.height / reach;
    const auto at = [&](int i, double height) {
        return Point{layout.left + (layout.right - layout.left) * (i + 0.5) / count,
                     layout.surface - scale * height};
    };
    // The sphere, whose surface is straight from so near, and the band of the error.
    out.box({0, layout.surface}, {out.width, out.height}, thin(sky, 0.25));
    out.box({0, layout.surface - scale * bound}, {out.width, layout.surface + scale * bound},
            thin(amber, 0.22));
    out.line({0, layout.surface}, {out.width, layout.surface}, {ink, 2});
    for (int i = 0; i < count; ++i) {
        const Departure& one = all[static_cast<std::size_t>(i)];
        const Ink color = one.is_right ? green : orange;
        if (c.way > 0) out.line(at(i, one.height), at(i, one.start), {thin(color, 0.5), 1});
        out.disc(at(i, one.height), 2, ink);
        out.disc(at(i, one.start), 3.5, color);
    }

    // One ray, with its direction.
    const Departure& middle = all[count / 2];
    const Point start = at(count / 2, middle.start);
    const double angle = rt::radians(c.angle);
    const Point tip = start + arrow_length * Point{std::sin(angle), -std::cos(angle)};
    out.arrow(start, tip, {accent, 3});
    out.line(start, start - Point{0, 50}, {muted, 1.5, 4});
    out.text(start - Point{0, 60}, "n", muted);
    out.handle(tip);

    if (out.is_narrow()) out.text_size = 11.5;
    out.text({10, layout.surface - scale * bound - 12}, "error bound: {e}", amber, Align::left,
             bound);
    out.text({10, out.height - 14}, "the sphere", ink, Align::left);
    out.text({out.width - 10, 14}, "starts of rays, up to {e} away", ink, Align::right, reach);
    const bool outward = c.angle <= 90;
    out.text({out.width - 10, out.height - 34},
             outward ? "leaves the sphere" : "meets the far side", green, Align::right);
    out.text({out.width - 10, out.height - 14},
             outward ? "meets the sphere again" : "does not meet the far side", orange,
             Align::right);

    if (outward)
        out.say("{} of {} rays meet the sphere that they leave.", double(wrong), double(count));
    else
        out.say("{} of {} rays into the sphere do not meet its far side.", double(wrong),
                double(count));
}

void drag(LeaveControls& c, const Drag& to) {
    // From wherever the arrow starts: only what has been moved counts.
    const double before = rt::radians(c.angle);
    const Point tip = arrow_length * Point{std::sin(before), -std::cos(before)} + to.moved();
    c.angle = in_degrees(std::abs(std::atan2(tip.x, -tip.y)));
}

// ---- The chapter's scene ----

void draw(const SceneControls& c, Drawing& out) {
    const double aspect = out.is_narrow() ? 1.3 : 1.9;
    out.height = out.width / aspect;
    const int columns = static_cast<int>(std::min(out.width * out.pixel_ratio, 560.0)),
              rows = static_cast<int>(columns / aspect);
    rt::View view = normals_aa::group_view();
    const double turn = rt::radians(c.turn), far = view.from.z;
    view.from = {far * std::sin(turn), view.from.y, far * std::cos(turn)};
    view.vertical_fov = rt::radians(out.is_narrow() ? 38 : 31);
    const auto refine = [&, scene = normals_aa::make_scene(),
                         camera = rt::make_camera(view, columns, rows)](const auto& ending) {
        out.refine(
            {0, 0}, {out.width, out.height}, columns, rows, c.what == 0 ? 400 : 16,
            [=, what = c.what, depth = static_cast<int>(c.depth)](int column, int row, int sample) {
                rt::Rng random = rt::pixel_rng(static_cast<unsigned>(sample), column, row);
                const rt::Ray ray = primary_ray(camera, column, row, random_place(random));
                if (what == 0)
                    return path_radiance(ray, scene.world, scene.materials, scene.sky, ending,
                                         depth, random);
                const auto hit = scene.world.hit(ray, {});
                if (!hit) return rt::from_hex(0x3a4256);
                const rt::Vec3 n = hit->normal;
                if (what == 2) return rt::Color{n.x + 1, n.y + 1, n.z + 1} / 2;
                return scene.materials.materials[static_cast<std::size_t>(hit->material)].albedo *
                       (0.04 + 0.96 * rt::lambert(n, scene.sky.to_sun));
            });
    };
    if (c.ending == 0)
        refine(rt::SkyEnding{});
    else if (c.ending == 1)
        refine(rt::BlackEnding{});
    else
        refine(rt::RouletteEnding{});
    out.handle_everywhere();
    if (c.what == 1)
        out.say("Lambert’s law for one light, without shadows: no ray bounces.");
    else if (c.what == 2)
        out.say("The normal at each point, as a color: x is red, y is green, z is blue.");
    else if (c.ending == 2)
        out.say("Roulette ends the paths, at the earliest after this many bounces: {}.", c.depth);
    else
        out.say("Bounces of a path: at most {}.", c.depth);
}

void drag(SceneControls& c, const Drag& to) {
    c.turn -= 150 * to.moved().x / to.width;
}

}  // namespace live
