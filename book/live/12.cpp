// The live figures of chapter 12.
#include <array>
#include <optional>
#include <rt/cut_ears.hpp>
#include <rt/hit_triangle.hpp>
#include <rt/lambert.hpp>
#include <rt/make_ball.hpp>
#include <rt/make_camera.hpp>
#include <rt/mesh_materials.hpp>
#include <rt/metal.hpp>
#include <rt/primary_ray.hpp>
#include <rt/sample_rng.hpp>
#include <string_view>
#include <vector>

#include "12.float.hpp"
#include "controls.hpp"
#include "live.hpp"
#include "plane.hpp"
#include "space.hpp"

namespace live {
namespace {

// ---- A ray meets a triangle ----

struct TriangleLayout {
    Frame face;    // the triangle from the front
    Point middle;  // of the view from the side
    double scale;
    Point list;
    double height;
};

TriangleLayout triangle_layout(double width) {
    const bool narrow = width < 520;
    const double scale = (narrow ? 1 : 0.56) * width / 6.6, face_height = 5.4 * scale;
    const Frame face{{3.3 * scale, face_height / 2}, {2, 1.5}, scale};
    if (narrow)
        return {face,
                {0.5 * width, face_height + 0.24 * width},
                width / 8.6,
                {12, face_height + 0.5 * width},
                face_height + 0.5 * width + 118};
    return {face,
            {0.79 * width, 0.14 * width},
            width / 21,
            {0.6 * width, 0.31 * width},
            std::max(face_height, 0.31 * width + 118)};
}

rt::Triangle triangle_of(const TriangleControls& c) {
    return {{0, 0, 0}, {4, 0, 0}, {c.cx, c.cy, 0}};
}

rt::Ray ray_to(const TriangleControls& c) {
    const double tilt = rt::radians(c.tilt);
    const bool along = std::abs(c.tilt) == 90;  // exactly, whatever cos says
    const rt::Vec3 d{std::sin(tilt), 0, along ? 0 : -std::cos(tilt)};
    return {rt::Vec3{c.x, c.y, 0} - c.start * d, d};
}

// A weight that should be 0 and is not, because it was rounded.
double weight(double w) {
    return std::abs(w) < 1e-12 ? 0 : w;
}

// The triangle and the ray, from the side.
void draw_side(const rt::Triangle& triangle, const rt::Ray& ray, double t, bool is_hit,
               const TriangleLayout& layout, Drawing& out) {
    const Space space{layout.middle, {2, 1.3, 1.4}, 52, 24, layout.scale};
    const auto corners = space.corners({triangle.a, triangle.b, triangle.c, triangle.a});
    const rt::Vec3 end = ray.at(t);
    const Point from = space.to_page(ray.origin), at = space.to_page(end),
                beyond = space.to_page(ray.origin + std::max(t + 1.5, 1.5) * ray.direction);
    const bool from_front = ray.direction.z <= 0;
    const auto draw_triangle = [&] {
        out.polygon(corners, thin(sky, 0.35));
        out.path(corners, {ink, 1.5});
    };
    // What the triangle hides is drawn before it.
    if (from_front && t >= 0) {
        out.arrow(at, beyond, {thin(muted, 0.8), 1.5});
        draw_triangle();
        out.line(from, at, {accent, 3});
    } else {
        out.line(from, space.to_page(end), {thin(muted, 0.8), 1.5, 4});
        out.arrow(from, beyond, {accent, 3});
        draw_triangle();
    }
    out.dot(at, is_hit ? accent : muted, 4);
    out.dot(from, ink, 3);
    out.text(from + Point{0, -14}, "o", ink);
    out.text(0.5 * (from + at) + Point{6, -14}, "t", accent);
}

}  // namespace

void draw(const TriangleControls& c, Drawing& out) {
    const TriangleLayout layout = triangle_layout(out.width);
    out.height = layout.height;
    const rt::Triangle triangle = triangle_of(c);
    const rt::Ray ray = ray_to(c);
    const rt::Vec3 point{c.x, c.y, 0};
    const auto hit = rt::hit_triangle(triangle, ray, {0, rt::infinity});
    // Of a hit, by hit_triangle; beside the triangle, by a function that knows the point.
    const rt::Vec2 weights = hit ? rt::Vec2{hit->u, hit->v} : rt::weights_at(triangle, point);
    const double u = weight(weights.x), v = weight(weights.y), w = weight(1 - u - v);
    const double det =
        rt::dot(triangle.b - triangle.a, rt::cross(ray.direction, triangle.c - triangle.a));

    // From the front: the three smaller triangles, each in the color of the corner across from it.
    const std::array corners{layout.face.to_page(in_plane(triangle.a)),
                             layout.face.to_page(in_plane(triangle.b)),
                             layout.face.to_page(in_plane(triangle.c))};
    const Point p = layout.face.to_page({c.x, c.y});
    const std::array inks{orange, blue, green};
    const std::array shares{w, u, v};
    const std::array<std::string_view, 3> names{"a", "b", "c"};
    const Point center = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
    for (std::size_t i = 0; i < 3; ++i) {
        const Point next = corners[(i + 1) % 3], last = corners[(i + 2) % 3];
        out.polygon({p, next, last}, thin(inks[i], shares[i] < 0 ? 0.08 : 0.28));
        // The side across from this corner, on and on: there its weight is 0.
        const double length = distance(next, last);
        if (length == 0) continue;
        const Point along = (2 * out.width / length) * (last - next);
        out.line(next - along, last + along, {thin(inks[i], 0.35), 1, 5});
    }
    out.box({layout.face.at.x + 3.3 * layout.face.scale, 0}, {out.width, out.height}, paper);
    out.box({0, 2 * layout.face.at.y}, {out.width, out.height}, paper);
    for (std::size_t i = 0; i < 3; ++i) {
        out.line(p, corners[i], {thin(ink, 0.5), 1.2, shares[i] < 0 ? 4.0 : 0.0});
        out.line(corners[i], corners[(i + 1) % 3], {ink, 2});
    }
    out.text_size = 14;
    for (std::size_t i = 0; i < 3; ++i) {
        const Point away = corners[i] - center;
        const double length = std::hypot(away.x, away.y);
        out.bold = true;
        out.text(corners[i] + (length > 0 ? 20 / length : 0) * away, names[i], inks[i]);
        out.bold = false;
        const Point inside = (1.0 / 3) * (p + corners[(i + 1) % 3] + corners[(i + 2) % 3]);
        if (shares[i] > 0.08) out.text(inside, "{.2}", inks[i], Align::middle, shares[i]);
    }
    out.handle(corners[2]);
    out.handle(p);
    out.bold = true;
    out.text(p + Point{18, 12}, "P", ink);
    out.bold = false;

    draw_side(triangle, ray, c.start, hit.has_value(), layout, out);

    // The tests, up to the one that fails.
    struct Test {
        std::string_view words;
        double number;
        bool passes;
    };
    const std::array tests{
        Test{"determinant {.2}: not 0", det, det != 0}, Test{"u = {.3}: at least 0", u, u >= 0},
        Test{"v = {.3}: at least 0", v, v >= 0}, Test{"u + v = {.3}: at most 1", u + v, w >= 0},
        Test{"t = {.3}: ahead", c.start, c.start >= 0}};
    out.text_size = 13;
    std::size_t failing = 0;
    while (failing < tests.size() && tests[failing].passes) ++failing;
    for (std::size_t i = 0; i < tests.size(); ++i) {
        const Point at = layout.list + Point{0, 12 + 21 * static_cast<double>(i)};
        const bool reached = i <= failing;
        out.text(at,
                 i < failing ? "✓"
                 : reached   ? "✗"
                             : "·",
                 i < failing ? green
                 : reached   ? orange
                             : muted,
                 Align::left);
        if (reached)
            out.text(at + Point{20, 0}, tests[i].words, ink, Align::left, tests[i].number);
        else
            out.text(at + Point{20, 0}, "not asked", muted, Align::left);
    }
    if (hit)
        out.say(
            "A hit at t = {.2}, with u = {.2} and v = {.2}. The weights of a, b and c are {.2}, "
            "{.2} and {.2}.",
            hit->t, u, v, w, u, v);
    else if (failing == tests.size() && u > 0 && v > 0 && w > 0)
        out.say(
            "No hit: the ray starts on the triangle itself, and rounding has put its start "
            "behind.");
    else if (failing == tests.size())
        out.say(
            "No hit: P is on the very edge, and hit_triangle leaves this ray to a triangle on the "
            "other side of it.");
    else if (failing == 0 && c.cy == 0)
        out.say("No hit: the triangle has no area, and the determinant is 0.");
    else if (failing == 0)
        out.say("No hit: the ray runs along the triangle, and the determinant is 0.");
    else if (failing == 4)
        out.say("No hit: P is in the triangle, but behind the start of the ray.");
    else
        out.say(
            "No hit: P is outside. The weights of a, b and c are {.2}, {.2} and {.2}, and one that "
            "is negative tells beyond which side.",
            w, u, v);
}

void drag(TriangleControls& c, const Drag& to) {
    const Frame face = triangle_layout(to.width).face;
    const std::array places{face.to_page({c.x, c.y}), face.to_page({c.cx, c.cy})};
    const std::size_t moved = nearest_of(places, to.down);
    const Point now = face.to_plane(places[moved] + to.moved());
    const Point rounded{std::round(20 * now.x) / 20, std::round(20 * now.y) / 20};
    (moved == 0 ? c.x : c.cx) = rounded.x;
    (moved == 0 ? c.y : c.cy) = rounded.y;
}

// ---- The edge that two triangles share ----

namespace {

struct EdgeLayout {
    Frame face;
    std::array<Point, 2> panels;  // their upper left corners
    double side, height;
};

EdgeLayout edge_layout(double width) {
    constexpr double title = 22, counts = 50;
    if (width < 520) {
        const double scale = width / 7.4, side = (width - 12) / 2, top = 5 * scale + 20 + title;
        return {{{width / 2, 2.5 * scale}, {2.5, 2}, scale},
                {Point{0, top}, Point{side + 12, top}},
                side,
                top + side + counts};
    }
    const double scale = 0.36 * width / 6, side = 0.285 * width;
    return {{{0.18 * width, title + side / 2}, {2.5, 2}, scale},
            {Point{0.4 * width, title}, Point{0.71 * width, title}},
            side,
            title + side + counts};
}

double in_float(double x) {
    return static_cast<double>(static_cast<float>(x));
}
Triple in_float(rt::Vec3 p) {
    return {in_float(p.x), in_float(p.y), in_float(p.z)};
}

// The corners a, b, c, d of the triangles a b c and d c b, and the eye.
struct Pair {
    std::array<rt::Vec3, 4> corners;
    rt::Vec3 eye;
};

Pair pair_of(const EdgeControls& c) {
    if (c.corners == 2) return {{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}}}, {1, 1, 4}};
    return {{{{0.1, 0.2, 0.3}, {3.7, 0.9, -0.7}, {1.3, 3.1, 0.45}, {4.9, 3.8, 0.2}}},
            {2.3, 1.7, 5.3}};
}

// Where a point is seen in the plane z = 0, from the eye.
Point seen_from(rt::Vec3 eye, rt::Vec3 p) {
    return in_plane(eye + eye.z / (eye.z - p.z) * (p - eye));
}

constexpr int cells = 40;

}  // namespace

void draw(const EdgeControls& c, Drawing& out) {
    const EdgeLayout layout = edge_layout(out.width);
    out.height = layout.height;
    const Pair pair = pair_of(c);
    const auto& [a, b, corner_c, d] = pair.corners;
    const double width = std::pow(10, c.closer);
    const std::array<rt::Color, 4> colors{rt::from_hex(0xd8321e), rt::from_hex(0x7fa8d8),
                                          rt::from_hex(0xa9c97f), rt::from_hex(0xf7d038)};

    // The triangles, as the eye sees them.
    const auto page = [&](rt::Vec3 p) { return layout.face.to_page(seen_from(pair.eye, p)); };
    out.polygon({page(a), page(b), page(corner_c)}, thin(shown(colors[1]), 0.55));
    out.polygon({page(d), page(corner_c), page(b)}, thin(shown(colors[2]), 0.55));
    out.path({page(b), page(a), page(corner_c), page(d), page(b)}, {ink, 1.5});
    out.line(page(b), page(corner_c), {ink, 2.5});
    const rt::Vec3 middle = b + c.place * (corner_c - b);
    const double half = std::max(3.0, 0.5 * width * layout.face.scale);
    const Point at = page(middle);
    out.frame(at - Point{half, half}, at + Point{half, half}, {accent, 1.5});
    out.handle(at);
    out.text({layout.face.at.x, layout.panels[0].y + (out.is_narrow() ? -46 : layout.side + 26)},
             "the square is {e} wide", ink, Align::middle, width);

    // Rays through the cells of a square around that point, in the plane of constant z.
    std::array<std::array<Triple, 3>, 2> triangles;
    const Triple fa = in_float(a), fb = in_float(b), fc = in_float(corner_c), fd = in_float(d);
    if (c.corners == 0)
        triangles = {{{fb, fc, fa}, {fc, fb, fd}}};
    else
        triangles = {{{fa, fb, fc}, {fd, fc, fb}}};
    std::array<Bytes*, 2> pictures{&out.picture(cells, cells), &out.picture(cells, cells)};
    std::array<std::array<int, 4>, 2> counts{};
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column) {
            const rt::Vec3 offset{width * ((column + 0.5) / cells - 0.5),
                                  width * (0.5 - (row + 0.5) / cells), 0};
            const EdgeHits hits =
                hits_in_float(triangles, in_float(pair.eye), in_float(middle + offset - pair.eye));
            const std::array both{hits.plain, hits.exercise};
            for (std::size_t i = 0; i < 2; ++i) {
                pictures[i]->set(column, row, colors[both[i]]);
                ++counts[i][both[i]];
            }
        }

    const std::array<std::string_view, 2> titles{
        out.is_narrow() ? "plain test" : "plain test, in float",
        out.is_narrow() ? "hit_triangle" : "hit_triangle, in float"};
    for (std::size_t i = 0; i < 2; ++i) {
        const Point corner = layout.panels[i], opposite = corner + Point{layout.side, layout.side};
        out.show(*pictures[i], corner, opposite, false);
        out.frame(corner, opposite, {accent, 1.5});
        const double x = 0.5 * (corner.x + opposite.x);
        out.bold = true;
        out.text({x, corner.y - 12}, titles[i], ink);
        out.bold = false;
        out.text({x, opposite.y + 16}, "no hit: {}", counts[i][0] ? orange : muted, Align::middle,
                 double(counts[i][0]));
        out.text({x, opposite.y + 36}, "two hits: {}", counts[i][3] ? orange : muted, Align::middle,
                 double(counts[i][3]));
    }
    out.say(
        "Of {} rays toward a square {e} wide, the plain test lets {} through, and with {} it hits "
        "both triangles. With hit_triangle it is {} and {}.",
        double(cells * cells), width, double(counts[0][0]), double(counts[0][3]),
        double(counts[1][0]), double(counts[1][3]));
}

void drag(EdgeControls& c, const Drag& to) {
    const EdgeLayout layout = edge_layout(to.width);
    const Pair pair = pair_of(c);
    const rt::Vec3 b = pair.corners[1], end = pair.corners[2];
    const auto page = [&](rt::Vec3 p) { return layout.face.to_page(seen_from(pair.eye, p)); };
    // Up or down by as much as the pointer.
    const double length = page(end).y - page(b).y;
    c.place += to.moved().y / length;
}

// ---- Smooth normals of a coarse shape ----

namespace {

struct DomeLayout {
    Frame frame;
    Point bars;  // the upper left corner of the first one
    double bar, height;
};

DomeLayout dome_layout(double width) {
    const bool narrow = width < 520;
    const double scale = (narrow ? 0.25 : 0.22) * width, bottom = 2.15 * scale;
    return {{{width / 2, bottom}, {0, -0.1}, scale},
            {width / 2 - scale, bottom + 34},
            20,
            bottom + (narrow ? 132 : 112)};
}

// Half a tube, seen from its end: flat sides between points of a circle of radius 1. Each side is
// two triangles, from z = -1 to z = 1; what is drawn is the plane z = 0.
class Dome {
  public:
    explicit Dome(int sides) : sides_{sides} {
        for (int i = 0; i < sides; ++i) {
            const auto low = [](rt::Vec3 p) { return p - rt::Vec3{0, 0, 1}; };
            const auto high = [](rt::Vec3 p) { return p + rt::Vec3{0, 0, 1}; };
            const rt::Vec3 p = rim(i), q = rim(i + 1);
            add({low(p), high(p), high(q)}, {p, p, q});
            add({low(p), high(q), low(q)}, {p, q, q});
        }
    }
    int sides() const { return sides_; }
    // A point where two sides meet; on the circle, so that it is the normal there, too.
    rt::Vec3 rim(int i) const {
        const double angle = rt::pi * (1 - static_cast<double>(i) / sides_);
        return {std::cos(angle), std::sin(angle), 0};
    }

    struct Meeting {
        rt::Vec3 point, flat, smooth;
    };
    std::optional<Meeting> hit(const rt::Ray& ray) const {
        std::optional<rt::TriangleHit> nearest;
        std::size_t which = 0;
        for (std::size_t i = 0; i < triangles_.size(); ++i)
            if (const auto t =
                    rt::hit_triangle(triangles_[i], ray, {0, nearest ? nearest->t : rt::infinity}))
                nearest = t, which = i;
        if (!nearest) return {};
        const auto& [a, b, c] = triangles_[which];
        const rt::Vec3 flat = rt::normalize(rt::cross(b - a, c - a));  // outward
        return Meeting{ray.at(nearest->t), flat,
                       rt::smooth_normal(normals_[which], nearest->u, nearest->v, flat)};
    }

  private:
    void add(rt::Triangle triangle, const std::array<rt::Vec3, 3>& normals) {
        triangles_.push_back(triangle);
        normals_.push_back(normals);
    }

    int sides_;
    std::vector<rt::Triangle> triangles_;
    std::vector<std::array<rt::Vec3, 3>> normals_;
};

// A ray of the sunlight, which passes the middle of the circle at this distance.
struct Sun {
    static constexpr double reach = 1.6;  // how far from the middle the drawn rays start

    rt::Vec3 to_sun, across;

    explicit Sun(double degrees) {
        const double angle = rt::radians(degrees);
        to_sun = {std::cos(angle), std::sin(angle), 0};
        across = {-to_sun.y, to_sun.x, 0};
    }
    rt::Ray ray(double beside) const { return {reach * to_sun + beside * across, -to_sun}; }
};

// Where a mirror sends the light, by the choice of the reader.
rt::Vec3 mirrored(double way, rt::Vec3 incoming, const Dome::Meeting& at) {
    const auto metal = [&](rt::Vec3 normal) {
        return rt::metal_direction(incoming, normal, 0, {});
    };
    if (way == 0) return metal(at.flat);
    if (way == 1) return metal(at.smooth);
    if (way == 2) return rt::keep_side(metal(at.smooth), at.smooth, at.flat);
    const rt::Vec3 bent = rt::bent_normal(at.smooth, at.flat, incoming);
    return rt::keep_side(metal(bent), bent, at.flat);
}

}  // namespace

void draw(const NormalsControls& c, Drawing& out) {
    const DomeLayout layout = dome_layout(out.width);
    out.height = layout.height;
    const Dome dome{static_cast<int>(c.sides)};
    const Sun sun{c.sun};
    const auto page = [&](rt::Vec3 p) { return layout.frame.to_page(in_plane(p)); };

    // The mesh, and the surface that is meant.
    std::vector<Point> rim, circle;
    for (int i = 0; i <= dome.sides(); ++i) rim.push_back(page(dome.rim(i)));
    for (int i = 0; i <= 60; ++i)
        circle.push_back(page({std::cos(rt::pi * i / 60), std::sin(rt::pi * i / 60), 0}));
    out.polygon(rim, thin(sky, 0.22));
    out.path(circle, {thin(blue, 0.7), 1.2, 5});
    out.path(rim, {ink, 2.5});
    for (const Point p : rim) out.disc(p, 3, ink);

    // Where sunlight goes from points all over the surface.
    constexpr int points = 54;
    int lit = 0, wrong = 0;
    for (int i = 0; i < points; ++i) {
        const double along = dome.sides() * (i + 0.5) / points;
        const int side = static_cast<int>(along);
        const rt::Vec3 p = dome.rim(side), point = p + (along - side) * (dome.rim(side + 1) - p);
        const rt::Ray ray = sun.ray(rt::dot(point, sun.across));
        const auto at = dome.hit(ray);
        if (!at || rt::length(at->point - point) > 1e-6) continue;  // in the shade
        const rt::Vec3 away = mirrored(c.way, ray.direction, *at);
        const bool is_wrong = !(rt::dot(away, at->flat) > 0);
        ++lit, wrong += is_wrong;
        out.line(page(point + 0.25 * sun.to_sun), page(point), {thin(amber, 0.6), 1});
        out.line(page(point), page(point + 0.45 * away),
                 {thin(is_wrong ? orange : green, is_wrong ? 0.9 : 0.55), is_wrong ? 1.8 : 1.2});
    }

    // One ray, with its normals.
    const rt::Ray ray = sun.ray(c.beside);
    const auto at = dome.hit(ray);
    const bool is_bent = c.way == 3;
    if (at) {
        const rt::Vec3 away = mirrored(c.way, ray.direction, *at), start = at->point;
        out.line(page(ray.origin), page(start), {amber, 3});
        out.arrow(page(start), page(start + 0.6 * at->flat), {muted, 2.5});
        out.arrow(page(start), page(start + 0.6 * at->smooth), {blue, 2.5});
        if (is_bent)
            out.arrow(page(start),
                      page(start + 0.6 * rt::bent_normal(at->smooth, at->flat, ray.direction)),
                      {pink, 2.5});
        out.arrow(page(start), page(start + 0.8 * away),
                  {rt::dot(away, at->flat) > 0 ? green : orange, 3.5});
        out.dot(page(start), ink, 4);
    } else {
        out.line(page(ray.origin), page(ray.at(2 * Sun::reach)), {amber, 3});
    }
    out.handle(page(ray.origin));

    struct Name {
        std::string_view words;
        Ink color;
    };
    const std::array names{Name{"light", amber},          Name{"flat normal", muted},
                           Name{"smooth normal", blue},   Name{"mirrored", green},
                           Name{"into the mesh", orange}, Name{"bent normal", pink}};
    const std::size_t in_row = out.is_narrow() ? 3 : 6;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (is_bent || names[i].words != "bent normal")
            out.text(
                {out.width * (static_cast<double>(i % in_row) + 0.5) / static_cast<double>(in_row),
                 layout.bars.y + 66 + 20 * static_cast<double>(i / in_row)},
                names[i].words, names[i].color);

    // The same shape of matte material, seen from above.
    constexpr int columns = 160;
    const double width = 2 * layout.frame.scale;
    for (const bool is_smooth : {false, true}) {
        Bytes& bar = out.picture(columns, 1);
        for (int i = 0; i < columns; ++i) {
            const double x = 2 * (i + 0.5) / columns - 1;
            const auto seen = dome.hit({{x, 3, 0}, {0, -1, 0}});
            const double light =
                seen ? rt::lambert(is_smooth ? seen->smooth : seen->flat, sun.to_sun) : 0;
            bar.set(i, 0, rt::mix({0.02, 0.025, 0.04}, {1, 0.8, 0.5}, light));
        }
        const Point corner = layout.bars + Point{0, is_smooth ? layout.bar + 4 : 0};
        out.show(bar, corner, corner + Point{width, layout.bar}, false);
        out.text(corner + Point{-8, layout.bar / 2}, is_smooth ? "smooth" : "flat", ink,
                 Align::right);
    }
    out.text(layout.bars + Point{width / 2, -12}, "seen from above, if the material is matte",
             muted);

    if (wrong)
        out.say(
            "From {} of {} points in the light, the mirror direction leads through the flat side, "
            "into the mesh.",
            double(wrong), double(lit));
    else
        out.say("From all {} points in the light, the mirror direction leads away from the mesh.",
                double(lit));
}

void drag(NormalsControls& c, const Drag& to) {
    const DomeLayout layout = dome_layout(to.width);
    const Point from = in_plane(Sun{c.sun}.ray(c.beside).origin);
    const Point now = layout.frame.to_plane(layout.frame.to_page(from) + to.moved());
    // The ray goes on as far beside the middle as before.
    const double beside =
        std::asin(std::clamp(c.beside / std::hypot(Sun::reach, c.beside), -1.0, 1.0));
    const double degrees = in_degrees(std::atan2(now.y, now.x) - beside);
    c.sun = degrees < -90 ? 180 : degrees;
}

// ---- A polygon, cut ear by ear ----

namespace {

struct Letter {
    std::vector<Point> corners;  // counterclockwise
    std::size_t marked;          // the corner that can be dragged
};

const Letter& letter_of(const EarsControls& c) {
    static const std::array letters{
        Letter{{{0, 3},
                {0, 0},
                {1, 0},
                {1, 1},
                {2, 1},
                {2, 0},
                {3, 0},
                {3, 3},
                {2, 3},
                {2, 2},
                {1, 2},
                {1, 3}},
               3},
        Letter{{{0.3, 3},
                {0.3, 0},
                {2.7, 0},
                {2.7, 0.6},
                {1, 0.6},
                {1, 1.2},
                {2.3, 1.2},
                {2.3, 1.8},
                {1, 1.8},
                {1, 2.4},
                {2.7, 2.4},
                {2.7, 3}},
               4},
        [] {
            Letter star{{}, 1};
            for (int i = 0; i < 10; ++i) {
                const double angle = rt::pi * (0.5 + i / 5.0), far = i % 2 == 0 ? 1.6 : 0.62;
                star.corners.push_back({1.5 + far * std::cos(angle), 1.35 + far * std::sin(angle)});
            }
            return star;
        }()};
    return letters[static_cast<std::size_t>(c.letter)];
}

std::vector<Point> polygon_of(const EarsControls& c) {
    const Letter& letter = letter_of(c);
    std::vector<Point> corners = letter.corners;
    corners[letter.marked] = corners[letter.marked] + Point{c.dx, c.dy};
    return corners;
}

struct EarsLayout {
    Frame frame;
    double height;

    explicit EarsLayout(double width)
        : frame{{width / 2, (width < 520 ? 0.47 : 0.27) * width},
                {1.5, 1.5},
                (width < 520 ? 0.25 : 0.145) * width},
          height{2 * frame.at.y + 30} {}
};

// A corner of what is left.
enum class Kind { ear, turned_in, blocked };
struct Judged {
    Kind kind = Kind::ear;
    std::size_t by = 0;  // the corner that is in the way
};

Judged judge(const rt::FlatPolygon& flat, const std::vector<std::size_t>& left, std::size_t i) {
    const std::size_t count = left.size(), a = left[(i + count - 1) % count], b = left[i],
                      c = left[(i + 1) % count];
    if (!(flat.area(a, b, c) > 0)) return {Kind::turned_in};
    for (const std::size_t p : left)
        if (p != a && p != b && p != c && flat.is_inside(p, a, b, c, true))
            return {Kind::blocked, p};
    return {};
}

}  // namespace

void draw(const EarsControls& c, Drawing& out) {
    const EarsLayout layout{out.width};
    out.height = layout.height;
    const std::vector<Point> corners = polygon_of(c);
    std::vector<rt::Vec3> points;
    for (const Point p : corners) points.push_back({p.x, p.y, 0});
    const auto page = [&](std::size_t i) { return layout.frame.to_page(corners[i]); };

    const auto ears = rt::ears_of(points);
    const rt::FlatPolygon flat{points, rt::area_vector(points)};
    std::vector<std::size_t> left(corners.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;

    // What has been cut off.
    const std::size_t cut = std::min(static_cast<std::size_t>(c.cut), ears.size());
    for (std::size_t k = 0; k < cut; ++k) {
        const auto& [a, b, d] = ears[k];
        out.polygon({page(a), page(b), page(d)}, thin(k % 2 == 0 ? green : blue, 0.3));
        out.path({page(a), page(b), page(d), page(a)}, {muted, 1});
        out.text((1.0 / 3) * (page(a) + page(b) + page(d)), "{}", ink, Align::middle,
                 double(k + 1));
        std::erase(left, b);
    }

    // What is left, and the next ear.
    const bool is_done = !ears.empty() && cut == ears.size();
    std::vector<Point> rest;
    for (const std::size_t i : left) rest.push_back(page(i));
    if (!is_done) {
        out.polygon(rest, thin(sky, 0.3));
        if (!ears.empty()) {
            const auto& [a, b, d] = ears[cut];
            out.polygon({page(a), page(b), page(d)}, paper);
            out.polygon({page(a), page(b), page(d)}, thin(amber, 0.35));
            out.line(page(a), page(d), {amber, 2, 6});
        }
        rest.push_back(rest.front());
        out.path(rest, {ink, 2.5});
    }

    // Each corner of it: an ear or not.
    int count = 0;
    for (std::size_t i = 0; i < left.size() && !is_done; ++i) {
        const Point at = page(left[i]), last = page(left[(i + left.size() - 1) % left.size()]),
                    next = page(left[(i + 1) % left.size()]), away = at - 0.5 * (last + next);
        const Judged judged = judge(flat, left, i);
        const double length = std::max(1e-9, std::hypot(away.x, away.y)),
                     outward = judged.kind == Kind::turned_in ? -24 : 24;
        const Point label = at + (outward / length) * away;
        count += judged.kind == Kind::ear;
        const Ink color = judged.kind == Kind::ear ? green : orange;
        out.dot(at, color, 4);
        if (judged.kind == Kind::ear)
            out.text(label, "{} ✓", color, Align::middle, double(left[i]));
        else if (judged.kind == Kind::turned_in)
            out.text(label, "{} ✗", color, Align::middle, double(left[i]));
        else
            out.text(label, "{} ✗{}", color, Align::middle, double(left[i]), double(judged.by));
    }
    out.handle(page(letter_of(c).marked));
    out.text({out.width / 2, out.height - 14},
             out.is_narrow() ? "✓ ear   ✗ turned inward   ✗3 corner 3 is in it"
                             : "✓ an ear   ✗ turned inward   ✗3 corner 3 is in the triangle",
             muted);

    if (ears.empty())
        out.say("Sides cross: no triangles cover this polygon once.");
    else if (is_done)
        out.say("Done: the polygon is {} triangles, two fewer than its corners.",
                double(ears.size()));
    else
        out.say("{} of {} corners are ears. The next one to be cut off is at corner {}.",
                double(count), double(left.size()), double(ears[cut][1]));
}

void drag(EarsControls& c, const Drag& to) {
    const double scale = EarsLayout{to.width}.frame.scale;
    c.dx = std::round(20 * (c.dx + to.moved().x / scale)) / 20;
    c.dy = std::round(20 * (c.dy - to.moved().y / scale)) / 20;
}

// ---- The shadow terminator ----

namespace {

// A ball of triangles, matte, with smooth normals.
class MatteBall {
  public:
    explicit MatteBall(int cuts)
        : mesh_{rt::make_ball(cuts)}, tree_{rt::make_wide_tree(rt::triangles_of(mesh_, 0, 0))} {}

    std::size_t triangles() const { return mesh_.triangles.size(); }

    // The share of sunlight that is seen along a ray, or none if the ray misses. Light over a
    // triangle's horizon starts this share of lift() above the triangle.
    std::optional<double> light(const rt::Ray& ray, rt::Vec3 to_sun, double share) const {
        const auto hit = tree_.hit(ray, {0, rt::infinity});
        if (!hit) return {};
        const auto number = static_cast<std::size_t>(rt::triangle_number(*hit));
        const rt::Triangle triangle = tree_.shape(static_cast<std::int32_t>(number)).shape;
        std::array<rt::Vec3, 3> normals;
        for (std::size_t k = 0; k < 3; ++k)
            normals[k] = mesh_.normals[static_cast<std::size_t>(mesh_.triangles[number][k].normal)];
        const rt::Vec2 weights = rt::weights_at(triangle, hit->point);
        const double lit =
            rt::lambert(rt::smooth_normal(normals, weights.x, weights.y, hit->normal), to_sun);
        if (!(lit > 0)) return 0;
        if (rt::dot(to_sun, hit->normal) > 0) return lit;  // nothing is in the way on a ball
        const rt::Vec3 lift = share * rt::lift(triangle, normals, weights.x, weights.y);
        if (lift == rt::Vec3{}) return 0;  // the triangle itself is in the way
        return tree_.occluded(rt::Ray{hit->point + lift, to_sun}, {0, rt::infinity}) ? 0 : lit;
    }

  private:
    rt::Mesh mesh_;
    rt::TriangleTree tree_;
};

std::optional<double> true_light(const rt::Ray& ray, rt::Vec3 to_sun) {
    const auto t = rt::hit_sphere(rt::unit_sphere, ray, {0, rt::infinity});
    if (!t) return {};
    return rt::lambert(ray.at(*t), to_sun);
}

rt::Vec3 sun_of(const TerminatorControls& c) {
    const double turn = rt::radians(c.sun);
    return rt::normalize(rt::Vec3{std::sin(turn), 0.55, std::cos(turn)});
}

rt::Camera ball_camera(int pixels) {
    return rt::make_camera({{0, 0, 6}, {0, 0, 0}, {0, 1, 0}, rt::radians(22.5)}, pixels, pixels);
}

}  // namespace

void draw(const TerminatorControls& c, Drawing& out) {
    constexpr double title = 26, gap = 12;
    const double side = std::min(360.0, (out.width - gap) / 2);
    const int pixels = static_cast<int>(std::min(side * out.pixel_ratio, 480.0));
    out.height = side + title;
    const double left = (out.width - 2 * side - gap) / 2;
    const auto ball = std::make_shared<MatteBall>(static_cast<int>(c.cuts));
    const rt::Vec3 to_sun = sun_of(c);
    const rt::Camera camera = ball_camera(pixels);
    const double share = c.lift;
    out.refine({left, title}, {left + 2 * side + gap, title + side}, 2 * pixels, pixels, 32,
               [ball, camera, to_sun, share, pixels](int column, int row, int sample) -> rt::Color {
                   const bool is_mesh = column < pixels;
                   rt::Rng random = rt::sample_rng(1, column % pixels, row, sample);
                   const rt::Ray ray =
                       rt::primary_ray(camera, column % pixels, row, rt::random_place(random));
                   // A sun that is a little larger than the real one.
                   const rt::Vec3 beside{random.uniform() - 0.5, random.uniform() - 0.5,
                                         random.uniform() - 0.5};
                   const rt::Vec3 sun = rt::normalize(to_sun + 0.04 * beside);
                   const auto light = is_mesh ? ball->light(ray, sun, share) : true_light(ray, sun);
                   if (!light) return {0.02, 0.025, 0.035};
                   return *light * rt::from_hex(0xf2bd98) + rt::Color{0.006, 0.007, 0.01};
               });
    out.box({out.width / 2 - gap / 2, title}, {out.width / 2 + gap / 2, out.height}, paper);
    out.bold = true;
    out.text({left, 12}, "{} triangles", ink, Align::left, double(ball->triangles()));
    out.text({left + side + gap, 12}, "the true ball", ink, Align::left);
    out.bold = false;
    out.handle_everywhere();

    // Where the true ball is lit, and the triangles are not.
    constexpr int grid = 160;
    const rt::Camera coarse = ball_camera(grid);
    int lit = 0, black = 0;
    for (int row = 0; row < grid; ++row)
        for (int column = 0; column < grid; ++column) {
            const rt::Ray ray = rt::primary_ray(coarse, column, row, {0.5, 0.5});
            const auto wanted = true_light(ray, to_sun), seen = ball->light(ray, to_sun, share);
            if (!wanted || !seen || !(*wanted > 0.02)) continue;
            ++lit;
            black += *seen == 0;
        }
    out.say("Of {} points that the sun lights on the true ball, {} are black on the triangles.",
            double(lit), double(black));
}

void drag(TerminatorControls& c, const Drag& to) {
    c.sun += 120 * to.moved().x / to.width;
}

}  // namespace live
