// The live figures of chapter 01.
#include <array>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/facing.hpp>
#include <rt/inverse.hpp>
#include <rt/length.hpp>
#include <rt/transform.hpp>

#include "controls.hpp"
#include "live.hpp"
#include "plane.hpp"

namespace live {
namespace {

rt::Vec3 in_space(Point p) {
    return {p.x, p.y, 0};
}
// A product of two vectors that are whole numbers of steps, a drag's or a slider's: exact, so that
// it is 0 if it looks like 0.
template <class Product>
double product_of_steps(Point a, Point b, double steps_per_unit, Product product) {
    const auto steps = [=](Point p) {
        return rt::Vec3{std::round(steps_per_unit * p.x), std::round(steps_per_unit * p.y), 0};
    };
    return product(steps(a), steps(b)) / (steps_per_unit * steps_per_unit);
}
double cross_z(rt::Vec3 a, rt::Vec3 b) {
    return rt::cross(a, b).z;
}

// ---- Dot and cross product ----

Frame products_frame(double width) {
    const double height = width * (width < 520 ? 0.7 : 0.52);
    return {{width / 2, height / 2}, {0, 0}, width / 9};
}

}  // namespace

void draw(const ProductsControls& c, Drawing& out) {
    const Frame at = products_frame(out.width);
    out.height = 2 * at.at.y;
    draw_grid(out, at);
    const Point a{c.ax, c.ay}, b{c.bx, c.by}, origin = at.to_page({0, 0});
    const double product = product_of_steps(a, b, 10, rt::dot),
                 area = product_of_steps(a, b, 10, cross_z);

    // The parallelogram: blue if b has to turn left to point along a, else orange.
    out.polygon({origin, at.to_page(a), at.to_page(a + b), at.to_page(b)},
                thin(area < 0 ? blue : orange, 0.18));
    out.path({at.to_page(a), at.to_page(a + b), at.to_page(b)},
             {thin(area < 0 ? blue : orange, 0.6), 1.2, 4});

    // The shadow of a on the line of b, and the angle.
    const double b_length = rt::length(in_space(b));
    if (b_length > 0) {
        const Point far = (6 / b_length) * b, foot = (product / (b_length * b_length)) * b;
        out.line(at.to_page(-1 * far), at.to_page(far), {muted, 1, 3});
        out.line(at.to_page(a), at.to_page(foot), {muted, 1.5, 4});
        out.line(origin, at.to_page(foot), {green, 7});
        if (rt::length(in_space(a)) > 0) {
            const double from = std::atan2(b.y, b.x), turn = -std::atan2(area, product),
                         middle = from + turn / 2;
            draw_arc(out, origin, 30, from, from + turn, {ink, 1.5});
            out.text(origin + 43 * Point{std::cos(middle), -std::sin(middle)}, "θ", ink);
        }
        // Beside the shadow, where a is not.
        const double side = area < 0 ? -1 : 1;
        const Point across{-side * b.y / b_length, side * b.x / b_length};
        if (std::abs(product / b_length) > 0.8)
            out.text(at.to_page(0.5 * foot) +
                         (16 + 24 * std::abs(across.x)) * Point{across.x, -across.y},
                     "|a| cos θ", green);
    }
    draw_vector(out, origin, at.to_page(b), "b", pink);
    draw_vector(out, origin, at.to_page(a), "a", accent);
    out.dot(origin, ink, 3);
    out.handle(at.to_page(b));
    out.handle(at.to_page(a));

    const double small = out.is_narrow() ? 12 : 14;
    out.text_size = small;
    out.bold = true;
    out.text({12, 18}, "a · b = {.2}", green, Align::left, product);
    out.text({12, 18 + 1.5 * small}, "a × b = (0, 0, {.2})", area < 0 ? blue : orange, Align::left,
             area);
    if (product == 0 || area == 0)
        out.say(area == 0 ? "a and b lie on one line." : "a and b are perpendicular.");
    else
        out.say(
            "The angle between a and b is {.1}°. The shadow’s length, negative if it points "
            "against "
            "b, times the length of b is the dot product: {.2} · {.2}. The parallelogram’s area is "
            "{.2}.",
            in_degrees(std::abs(std::atan2(area, product))), product / b_length, b_length,
            std::abs(area));
}

void drag(ProductsControls& c, const Drag& to) {
    const Frame at = products_frame(to.width);
    const std::array tips{at.to_page({c.ax, c.ay}), at.to_page({c.bx, c.by})};
    const std::size_t tip = nearest_of(tips, to.down);
    // To whole tenths, so that you can hit right angles.
    const Point now = at.to_plane(tips[tip] + to.moved()),
                rounded{std::round(10 * now.x) / 10, std::round(10 * now.y) / 10};
    (tip == 0 ? c.ax : c.bx) = rounded.x;
    (tip == 0 ? c.ay : c.by) = rounded.y;
}

// ---- What a matrix does to a grid ----

namespace {

Frame matrix_frame(double width) {
    const double height = width * (width < 520 ? 0.8 : 0.56);
    return {{width / 2, height / 2}, {0.6, 0.3}, width / (width < 520 ? 6.5 : 8.5)};
}

rt::Mat4 matrix_of(const MatrixControls& c) {
    return rt::from_columns({c.ux, c.uy, 0}, {c.vx, c.vy, 0}, {0, 0, 1}, {c.tx, c.ty, 0});
}

// A house on the grid, two units wide. Its door is on the left, so that you see when it is
// mirrored.
void draw_house(Drawing& out, const Frame& at, const rt::Mat4& m, Ink color, double strength) {
    const auto place = [&](double x, double y) {
        return at.to_page(in_plane(rt::transform_point(m, {x, y, 0})));
    };
    out.polygon({place(0, 0), place(2, 0), place(2, 1), place(1, 1.8), place(0, 1)},
                thin(color, 0.25 * strength));
    out.path({place(0, 0), place(2, 0), place(2, 1), place(1, 1.8), place(0, 1), place(0, 0)},
             {thin(color, strength), 2});
    out.polygon({place(0.3, 0), place(0.75, 0), place(0.75, 0.75), place(0.3, 0.75)},
                thin(color, 0.7 * strength));
    out.polygon({place(1.2, 0.4), place(1.7, 0.4), place(1.7, 0.8), place(1.2, 0.8)},
                thin(amber, 0.9 * strength));
}

}  // namespace

void draw(const MatrixControls& c, Drawing& out) {
    const Frame at = matrix_frame(out.width);
    out.height = 2 * at.at.y;
    const rt::Mat4 m = matrix_of(c);
    draw_grid(out, at);
    draw_house(out, at, {}, muted, 0.7);
    out.arrow(at.to_page({0, 0}), at.to_page({1, 0}), {thin(orange, 0.6), 2});
    out.arrow(at.to_page({0, 0}), at.to_page({0, 1}), {thin(green, 0.6), 2});
    out.text(at.to_page({0.5, 0}) + Point{0, 13}, out.is_narrow() ? "x" : "x axis", orange);
    out.text(at.to_page({0, 1}) + Point{-8, 0}, out.is_narrow() ? "y" : "y axis", green,
             Align::right);
    out.text(at.to_page({0, 0}) + Point{-8, 12}, "the old origin", muted, Align::right);
    for (int i = -5; i <= 5; ++i) {  // the grid, transformed as well
        const auto place = [&](double x, double y) {
            return at.to_page(in_plane(rt::transform_point(m, {x, y, 0})));
        };
        out.line(place(i, -5), place(i, 5), {thin(accent, 0.3), 1});
        out.line(place(-5, i), place(5, i), {thin(accent, 0.3), 1});
    }
    draw_house(out, at, m, accent, 1);

    const Point t{c.tx, c.ty}, u{c.ux, c.uy}, v{c.vx, c.vy};
    out.line(at.to_page({0, 0}), at.to_page(t), {ink, 1.5, 4});
    out.text(at.to_page(0.5 * t) + Point{0, 14}, "t", ink);
    draw_vector(out, at.to_page(t), at.to_page(t + u), "u", orange);
    draw_vector(out, at.to_page(t), at.to_page(t + v), "v", green);
    out.handle(at.to_page(t + u));
    out.handle(at.to_page(t + v));
    out.handle(at.to_page(t));

    const Point corner{2, 1};
    const rt::Vec3 moved = rt::transform_point(m, in_space(corner));
    out.dot(at.to_page(corner), muted, 4);
    out.text(at.to_page(corner) + Point{10, 0}, "(2, 1)", muted, Align::left);
    out.dot(at.to_page(in_plane(moved)), ink, 4);
    const Point end = at.to_page(in_plane(moved));
    if (out.is_narrow())
        out.text({std::clamp(end.x, 76.0, out.width - 76), end.y - 16}, "M (2, 1) = 2u + v + t");
    else
        out.text(end + Point{10, 0}, "M (2, 1) = 2u + v + t", ink, Align::left);
    const double determinant = product_of_steps(u, v, 20, cross_z);
    out.say(determinant == 0
                ? "The point (2, 1) goes to ({.2}, {.2}). The determinant is {}: everything is "
                  "flat, and there is no way back."
            : determinant < 0
                ? "The point (2, 1) goes to ({.2}, {.2}). The determinant is {.2}: a mirror "
                  "image, with areas multiplied by {.2}."
                : "The point (2, 1) goes to ({.2}, {.2}). The determinant is {.2}: areas are "
                  "multiplied by it.",
            moved.x, moved.y, determinant, -determinant);
}

void drag(MatrixControls& c, const Drag& to) {
    const Frame at = matrix_frame(to.width);
    const Point t{c.tx, c.ty};
    const std::array tips{at.to_page(t), at.to_page(t + Point{c.ux, c.uy}),
                          at.to_page(t + Point{c.vx, c.vy})};
    const std::size_t tip = nearest_of(tips, to.down);
    const Point now = at.to_plane(tips[tip] + to.moved()) - (tip == 0 ? Point{} : t);
    const Point rounded{std::round(20 * now.x) / 20, std::round(20 * now.y) / 20};
    (tip == 0 ? c.tx : tip == 1 ? c.ux : c.vx) = rounded.x;
    (tip == 0 ? c.ty : tip == 1 ? c.uy : c.vy) = rounded.y;
}

// ---- Normals of a stretched disk ----

namespace {

struct NormalsFrames {
    Frame before, after;
    double height;
};

NormalsFrames normals_frames(double width) {
    if (width < 520) {  // one above the other
        const double scale = width / 7;
        return {{{width / 2, 1.9 * scale}, {}, scale},
                {{width / 2, 5.9 * scale}, {}, scale},
                8 * scale};
    }
    const double scale = width / 10.4;
    return {{{2.3 * scale, 2.1 * scale}, {}, scale},
            {{7.2 * scale, 2.1 * scale}, {}, scale},
            4.2 * scale};
}

rt::Mat4 matrix_of(const NormalsControls& c) {
    return rt::from_columns({c.stretch, 0, 0}, {c.shear, 1, 0}, {0, 0, 1});
}

Point on_disk(double degrees) {
    return {std::cos(rt::radians(degrees)), std::sin(rt::radians(degrees))};
}

void draw_ellipse(Drawing& out, const Frame& at, const rt::Mat4& m) {
    std::vector<Point> rim;
    for (int i = 0; i <= 90; ++i)
        rim.push_back(at.to_page(in_plane(rt::transform_point(m, in_space(on_disk(4 * i))))));
    out.polygon(rim, thin(sky, 0.2));
    out.path(rim, {sky, 2});
}

}  // namespace

void draw(const NormalsControls& c, Drawing& out) {
    const NormalsFrames frames = normals_frames(out.width);
    const Frame &before = frames.before, &after = frames.after;
    out.height = frames.height;
    const rt::Mat4 m = matrix_of(c), back = rt::inverse(m);
    draw_ellipse(out, before, {});
    draw_ellipse(out, after, m);

    // All around, thin; then at the point that can be dragged.
    const auto normals_at = [&](double degrees, double strength) {
        const rt::Vec3 n = in_space(on_disk(degrees)), place = rt::transform_point(m, n);
        const rt::Vec3 right = rt::normalize(rt::transform_normal(back, n)),
                       wrong = rt::normalize(rt::transform_vector(m, n));
        const auto arrow = [&](const Frame& at, rt::Vec3 from, rt::Vec3 along, Ink color) {
            out.arrow(at.to_page(in_plane(from)), at.to_page(in_plane(from + 0.75 * along)),
                      {thin(color, strength), strength < 1 ? 1.2 : 3});
        };
        arrow(before, n, n, ink);
        arrow(after, place, wrong, orange);
        arrow(after, place, right, blue);
        return std::array{right, wrong};
    };
    for (int degrees = 0; degrees < 360; degrees += 30) normals_at(degrees, 0.3);

    const rt::Vec3 n = in_space(on_disk(c.angle)), along{-n.y, n.x, 0};
    const rt::Vec3 surface = rt::normalize(rt::transform_vector(m, along));
    const auto tangent = [&](const Frame& at, rt::Vec3 place, rt::Vec3 direction) {
        out.line(at.to_page(in_plane(place - 1.1 * direction)),
                 at.to_page(in_plane(place + 1.1 * direction)), {muted, 1.5, 5});
    };
    tangent(before, n, along);
    tangent(after, rt::transform_point(m, n), surface);
    const auto [right, wrong] = normals_at(c.angle, 1);
    const auto name = [&](const Frame& at, rt::Vec3 place, rt::Vec3 along_it, double far,
                          std::string_view letters, Ink color) {
        out.text(at.to_page(in_plane(place + (far + 16 / at.scale) * along_it)), letters, color);
    };
    const rt::Vec3 moved = rt::transform_point(m, n);
    out.bold = true;
    name(before, n, n, 0.75, "n", ink);
    name(before, n, along, 1.1, "s", muted);
    name(after, moved, surface, 1.1, "M s", muted);
    name(after, moved, right, 0.75, "n′", blue);
    if (rt::dot(right, wrong) < 0.94) name(after, moved, wrong, 0.75, "M n", orange);
    out.bold = false;
    out.handle(before.to_page(in_plane(n)));
    out.dot(after.to_page(in_plane(rt::transform_point(m, n))), ink, 4);
    out.handle(after.to_page({c.stretch, 0}));
    out.handle(after.to_page({c.shear, 1}));

    const double bottom = after.at.y + 1.95 * after.scale - (out.is_narrow() ? 8 : 0);
    out.text({before.at.x, before.at.y + bottom - after.at.y}, "a ball", ink);
    const bool narrow = out.is_narrow();
    out.text({after.at.x - 6, bottom}, narrow ? "transposed inverse" : "by the transposed inverse",
             blue, Align::right);
    out.text({after.at.x + 6, bottom}, narrow ? "matrix M: wrong" : "by the matrix M: wrong",
             orange, Align::left);
    out.say(
        "Angle to the surface: {.1}° with the transposed inverse, {.1}° with the matrix itself.",
        in_degrees(std::acos(std::clamp(rt::dot(right, surface), -1.0, 1.0))),
        in_degrees(std::acos(std::clamp(rt::dot(wrong, surface), -1.0, 1.0))));
}

void drag(NormalsControls& c, const Drag& to) {
    const auto [before, after, height] = normals_frames(to.width);
    const std::array handles{before.to_page(on_disk(c.angle)), after.to_page({c.stretch, 0}),
                             after.to_page({c.shear, 1})};
    const std::size_t handle = nearest_of(handles, to.down);
    const Point now = handles[handle] + to.moved();
    if (handle == 0) {
        const Point p = before.to_plane(now);
        const double degrees = in_degrees(std::atan2(p.y, p.x));
        c.angle = degrees < 0 ? degrees + 360 : degrees;
    } else if (handle == 1) {
        c.stretch = after.to_plane(now).x;
    } else {
        c.shear = after.to_plane(now).x;
    }
}

// ---- Rounding and cancellation on a number line ----

namespace {

// Where the number line is, from 0 to 8.
Frame number_line(double width) {
    return {{24, 92}, {0, 0}, (width - 48) / 8};
}

// The position of the last binary digit of x > 0 if it has so many of them: -2 for quarters.
int last_digit(double x, double digits) {
    return std::ilogb(x) - static_cast<int>(digits) + 1;
}
double rounded(double x, double digits) {
    const double unit = std::ldexp(1, last_digit(x, digits));
    return unit * std::nearbyint(x / unit);
}

// The binary digits of x from its first one on. Those below `last` are not known.
void draw_digits(Drawing& out, const char* name, double x, int last, double y) {
    constexpr int first = 2, lowest = -8;
    const double left = out.is_narrow() ? 70 : 100,
                 step = (out.width - left - 30) / (first - lowest);
    out.text({left - 22, y}, name, ink, Align::right);
    bool begun = false;
    for (int place = first; place >= lowest; --place) {
        const bool is_one = std::fmod(std::floor(std::ldexp(x, -place)), 2) == 1;
        begun = begun || is_one || (place < last && x == 0);
        if (!begun) continue;
        const Point at{left + step * (first - place), y};
        out.text(at, place < last ? "?" : is_one ? "1" : "0", place < last ? orange : ink);
    }
    out.text({left + step * (first + 0.5), y}, ".", muted);
}

}  // namespace

void draw(const DigitsControls& c, Drawing& out) {
    const Frame line = number_line(out.width);
    out.height = 276;
    const auto at = [&](double x, double above = 0) {
        return line.to_page({x, 0}) - Point{0, above};
    };
    out.line(at(0), at(8), {muted, 1.5});
    for (int power = 2; power >= -6; --power) {  // the numbers that there are
        const double from = std::ldexp(1, power), unit = std::ldexp(1, last_digit(from, c.digits));
        if (unit * line.scale < 2.5) continue;
        for (double x = from; x < 2 * from; x += unit) out.line(at(x, 6), at(x, -6), {faint, 1.2});
    }
    for (const double x : {0.0, 1.0, 2.0, 4.0, 8.0}) {
        out.line(at(x, 9), at(x, -9), {muted, 1.5});
        out.text(at(x, -22), "{}", muted, Align::middle, x);
    }

    const double a = rounded(c.a, c.digits), b = rounded(c.b, c.digits);
    const auto draw_number = [&](const char* name, double exact, double near, Ink color) {
        out.line(at(exact, 44), at(exact, 12), {color, 1.2, 3});
        out.arrow(at(exact, 12), at(near, 2), {color, 1.6});
        out.dot(at(near), color, 4.5);
        out.text(at(exact, 66), name, color);
        out.handle(at(exact, 46));
    };
    draw_number("a", c.a, a, blue);
    draw_number("b", c.b, b, green);

    const int last_a = last_digit(a, c.digits), last_b = last_digit(b, c.digits),
              last = std::max(last_a, last_b);
    const double difference = std::abs(a - b);
    out.text_size = 15;
    draw_digits(out, "a", a, last_a, 160);
    draw_digits(out, "b", b, last_b, 190);
    out.line({24, 208}, {out.width - 24, 208}, {faint, 1});
    draw_digits(out, out.is_narrow() ? "|a−b|" : "|a − b|", difference, last, 230);
    out.text_size = 13;
    out.text({24, 260},
             out.is_narrow() ? "binary digits; ? was rounded away"
                             : "binary digits; ? is not known, because it was rounded away",
             muted, Align::left);

    const int known = difference > 0 ? std::ilogb(difference) - last + 1 : 0;
    out.say(
        "a − b = {}. Rounded to {} digits first, it is {}: off by {.0} %, and {} of its digits are "
        "known.",
        c.a - c.b, c.digits, a - b,
        c.a == c.b ? 0 : 100 * std::abs((a - b) - (c.a - c.b)) / std::abs(c.a - c.b), known);
}

void drag(DigitsControls& c, const Drag& to) {
    const Frame line = number_line(to.width);
    const auto handle = [&](double x) { return line.to_page({x, 0}) - Point{0, 46}; };
    double& moved = nearest_of(std::array{handle(c.a), handle(c.b)}, to.down) == 0 ? c.a : c.b;
    moved = line.to_plane(line.to_page({moved, 0}) + to.moved()).x;
}

}  // namespace live
