#include <algorithm>
#include <cmath>
#include <companion/follow/trail_drawing.hpp>
#include <companion/pages/html.hpp>
#include <cstdio>
#include <functional>
#include <optional>

namespace companion {
namespace {

using rt::Vec3;

constexpr double gap = 14, side = 473;  // between the views, and of the two square ones
constexpr double width = 2 * side + 3 * gap;

constexpr const char* style = R"(<style>
svg{--paper:#fff;--ground:#f5f6f8;--ink:#1c2026;--muted:#57606a;--line:#8b94a0;--light:#b84300;--inside:#0067a3;font:13px system-ui,sans-serif}
@media(prefers-color-scheme:dark){svg{--paper:#16181d;--ground:#1e2127;--ink:#dfe2e7;--muted:#a2abb6;--line:#6d7682;--light:#f0874a;--inside:#5aa9e6}}
.paper{fill:var(--paper)}.ground{fill:var(--ground)}.ball{fill:none;stroke:var(--line)}
path{fill:none;stroke:var(--light);stroke-width:2}.inside{stroke:var(--inside)}.shadow{stroke-width:1.5;stroke-dasharray:2 3}
.halo{stroke:var(--paper);stroke-width:5;stroke-opacity:.7}.tip{fill:var(--light);stroke:none}
.point{fill:var(--paper);stroke:var(--light);stroke-width:1.5}text{fill:var(--ink);text-anchor:middle}.name{fill:var(--muted);text-anchor:start}
</style>
)";

struct Point {
    double x, y;
};

// A ray from its origin to where it ends; if it meets nothing, to anywhere in its direction.
struct Leg {
    Vec3 from, to;
    enum Kind { ends, leaves, shadow } kind;
    bool is_inside;  // of the sphere that it meets
};

struct Ball {
    Vec3 center;
    double radius;
};

struct Path {
    std::vector<Leg> legs;
    std::vector<Ball> balls;
};

bool is_finite(Vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double distance(Vec3 a, Vec3 b) {
    return length_of(along(a, -1, b));
}

Path path_of(const Trail& trail) {
    Path path;
    std::optional<Leg> ray;  // the last one
    const auto add = [&] {
        if (ray && is_finite(ray->from) && is_finite(ray->to)) path.legs.push_back(*ray);
        ray.reset();
    };
    std::vector<Leg> shadows;
    Vec3 end{};
    for (const TrailStep& step : trail) {
        if (step.name == "ray") {
            add();
            const Vec3 from = step.vector("origin");
            ray = Leg{from, along(from, 1, step.vector("direction")), Leg::leaves, false};
        } else if ((step.name == "hit" || step.name == "fog") && ray) {
            ray->to = end = step.vector("point");
            ray->kind = Leg::ends;
            ray->is_inside = step.has("front") && step.number("front") == 0;
            if (step.has("radius"))
                path.balls.push_back({step.vector("center"), step.number("radius")});
        } else if (step.name == "shadow") {
            const Vec3 from = step.vector("origin");
            shadows.push_back({from, along(from, step.number("distance"), step.vector("direction")),
                               Leg::shadow, false});
        } else if (step.name == "sky" && ray && ray->kind == Leg::ends) {
            add();  // the limit of bounces is reached
            ray = Leg{end, along(end, 1, step.vector("direction")), Leg::leaves, false};
        }
    }
    add();
    // A ray into the sky is drawn about as long as the path is wide.
    double reach = 0;
    for (const Leg& a : path.legs)
        for (const Leg& b : path.legs)
            if (a.kind == Leg::ends && b.kind == Leg::ends)
                reach = std::max(reach, distance(a.to, b.to));
    if (reach == 0 && !path.legs.empty()) reach = distance(path.legs[0].from, path.legs[0].to) / 4;
    for (Leg& leg : path.legs)
        if (leg.kind == Leg::leaves)
            leg.to =
                along(leg.from, reach / distance(leg.from, leg.to), along(leg.to, -1, leg.from));
    path.legs.insert(path.legs.end(), shadows.begin(), shadows.end());
    return path;
}

std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", x);
    return text;
}

std::string attribute(const char* name, double x) {
    return std::string{" "} + name + "=\"" + number(x) + '"';
}

// A part of the drawing, and where a point of the scene is in it; none if that is behind the
// camera.
struct View {
    std::string name;
    double left, top, width, height;
    std::function<std::optional<Point>(Vec3)> place;
    double scale = 0;  // of the circles; 0: there are none

    bool contains(Point p) const {
        return left <= p.x && p.x <= left + width && top <= p.y && p.y <= top + height;
    }
};

// Over the picture. The sizes are those of the view, in pixels.
View picture_view(const TrailStep& camera, double scale, double picture_width,
                  double picture_height) {
    const Vec3 eye = camera.vector("eye"), u = camera.vector("u"), v = camera.vector("v"),
               w = camera.vector("w");
    const std::vector<double> viewport = camera.numbers("viewport");
    const double columns = camera.number("columns"), rows = camera.number("rows"),
                 left = camera.number("left"), top = camera.number("top");
    return {"", gap, gap, picture_width, picture_height, [=](Vec3 point) -> std::optional<Point> {
                const Vec3 to = along(point, -1, eye);
                const double depth = -dot_of(to, w);
                if (!(depth > 0)) return {};
                const double x = dot_of(to, u) / depth / viewport.at(0) + 0.5,
                             y = 0.5 - dot_of(to, v) / depth / viewport.at(1);
                return Point{gap + scale * (left + x * columns), gap + scale * (top + y * rows)};
            }};
}

// Along an axis: `flat` gives the coordinates that are seen, of which the second one grows upward.
View square_view(const std::string& name, const Path& path, double left, double top,
                 const std::function<Point(Vec3)>& flat) {
    Point low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
    const auto take = [&](Vec3 point, double around) {
        const Point p = flat(point);
        low = {std::min(low.x, p.x - around), std::min(low.y, p.y - around)};
        high = {std::max(high.x, p.x + around), std::max(high.y, p.y + around)};
    };
    for (const Leg& leg : path.legs)
        if (leg.kind != Leg::shadow) take(leg.to, 0);
    if (path.legs.size() == 1) take(path.legs[0].from, 0);
    const double wide = std::max(high.x - low.x, high.y - low.y);
    for (const Ball& ball : path.balls)
        if (ball.radius < 2 * wide) take(ball.center, ball.radius);
    const double scale = side / 1.25 / std::max({high.x - low.x, high.y - low.y, 1e-300});
    const Point middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
    return {name,
            left,
            top,
            side,
            side,
            [=](Vec3 point) -> std::optional<Point> {
                const Point p = flat(point);
                return Point{left + side / 2 + scale * (p.x - middle.x),
                             top + side / 2 - scale * (p.y - middle.y)};
            },
            scale};
}

Vec3 halfway(Vec3 a, Vec3 b) {
    return along(a, 0.5, along(b, -1, a));
}

// The part of a leg that is in front of the camera and, if the leg has an arrow, ends in the view.
std::optional<std::pair<Point, Point>> seen(const View& view, const Leg& leg) {
    Vec3 from = leg.from, to = leg.to;
    const bool has_from = view.place(from).has_value(), has_to = view.place(to).has_value();
    if (!has_from && !has_to) return {};
    const auto nearly = [&](Vec3 hidden, Vec3 visible) {
        for (int i = 0; i < 12; ++i) {
            const Vec3 middle = halfway(hidden, visible);
            (view.place(middle) ? visible : hidden) = middle;
        }
        return visible;
    };
    if (!has_from) from = nearly(from, to);
    if (!has_to) to = nearly(to, from);
    for (int i = 0; i < 6 && leg.kind == Leg::leaves && !view.contains(*view.place(to)); ++i)
        to = halfway(from, to);
    return std::pair{*view.place(from), *view.place(to)};
}

// Where a point's number stands: beside it, away from the lines to two others, where no other
// number is yet.
Point free_place(Point point, Point before, Point after, const std::vector<Point>& taken) {
    const auto angle_to = [&](Point other) {
        return std::atan2(other.y - point.y, other.x - point.x);
    };
    const double middle = (angle_to(before) + angle_to(after)) / 2,
                 away = std::abs(angle_to(before) - angle_to(after)) < std::acos(-1)
                            ? middle + std::acos(-1)
                            : middle;
    Point place{};
    for (int turn = 0; turn < 12; ++turn) {
        const double angle = away + 2.4 * turn, far = turn < 6 ? 17 : 34;
        place = {point.x + far * std::cos(angle), point.y + far * std::sin(angle)};
        if (std::none_of(taken.begin(), taken.end(), [&](Point other) {
                return std::hypot(other.x - place.x, other.y - place.y) < 17;
            }))
            break;
    }
    return place;
}

std::string drawn(const View& view, const Path& path) {
    std::string circles, halos, lines, points;
    if (view.scale > 0)
        for (const Ball& ball : path.balls) {
            const Point center = *view.place(ball.center);
            circles += "<circle class=\"ball\"" + attribute("cx", center.x) +
                       attribute("cy", center.y) + attribute("r", view.scale * ball.radius) +
                       "/>\n";
        }
    std::vector<Point> labels;
    int count = 0;
    for (std::size_t i = 0; i < path.legs.size(); ++i) {
        const Leg& leg = path.legs[i];
        count += leg.kind != Leg::shadow;
        const auto line = seen(view, leg);
        if (!line) continue;
        const auto& [from, to] = *line;
        if (leg.kind == Leg::leaves && std::hypot(to.x - from.x, to.y - from.y) < 2) {
            // Seen from its origin, it is a point.
            points += "<circle class=\"point\"" + attribute("cx", to.x) + attribute("cy", to.y) +
                      " r=\"4\"/>\n";
            continue;
        }
        const std::string d = " d=\"M" + number(from.x) + ' ' + number(from.y) + 'L' +
                              number(to.x) + ' ' + number(to.y) + "\"/>\n";
        halos += "<path class=\"halo\"" + d;
        lines += std::string{"<path"} +
                 (leg.is_inside             ? " class=\"inside\""
                  : leg.kind == Leg::shadow ? " class=\"shadow\""
                                            : "") +
                 (leg.kind == Leg::leaves ? " marker-end=\"url(#tip)\"" : "") + d;
        if (leg.kind != Leg::ends || !view.place(leg.to) || !view.contains(to)) continue;
        const auto next = i + 1 < path.legs.size() ? seen(view, path.legs[i + 1]) : std::nullopt;
        const Point label = free_place(to, from, next ? next->second : to, labels);
        labels.push_back(label);
        points += "<circle class=\"point\"" + attribute("cx", to.x) + attribute("cy", to.y) +
                  " r=\"2.5\"/><circle class=\"point\"" + attribute("cx", label.x) +
                  attribute("cy", label.y) + " r=\"8.5\"/><text" + attribute("x", label.x) +
                  attribute("y", label.y + 4.5) + '>' + std::to_string(count) + "</text>\n";
    }
    return circles + halos + lines + points;
}

}  // namespace

std::string drawn(const Trail& trail, const TrailPicture& picture) {
    const Path path = path_of(trail);
    const TrailStep& camera = trail.front();
    double columns = picture.width, rows = picture.height;
    if (picture.png.empty()) {  // what the camera sees
        columns = camera.number("left") + camera.number("columns");
        rows = camera.number("top") + camera.number("rows");
    }
    const double picture_width = width - 2 * gap, scale = picture_width / columns,
                 picture_height = scale * rows, below = picture_height + 2 * gap;
    std::vector<View> views{
        square_view("From above: x to the right, z down", path, gap, below,
                    [](Vec3 v) {
                        return Point{v.x, -v.z};
                    }),
        square_view("From the side: z to the left, y up", path, side + 2 * gap, below, [](Vec3 v) {
            return Point{-v.z, v.y};
        })};
    views.push_back(picture_view(camera, scale, picture_width, picture_height));
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(width) +
                      ' ' + number(below + side + gap) + "\">\n" + style +
                      "<defs><marker id=\"tip\" viewBox=\"0 0 8 8\" refX=\"6\" refY=\"4\" "
                      "markerWidth=\"5\" markerHeight=\"5\" orient=\"auto\"><path class=\"tip\" "
                      "d=\"M0 0L8 4L0 8Z\"/></marker></defs>\n"
                      "<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n";
    for (const View& view : views) {
        const std::string box = attribute("x", view.left) + attribute("y", view.top) +
                                attribute("width", view.width) + attribute("height", view.height);
        svg += "<svg" + box + " viewBox=\"" + number(view.left) + ' ' + number(view.top) + ' ' +
               number(view.width) + ' ' + number(view.height) + "\">\n<rect class=\"ground\"" +
               box + "/>\n";
        if (view.scale == 0 && !picture.png.empty())
            svg +=
                "<image" + box + " href=\"data:image/png;base64," + base64(picture.png) + "\"/>\n";
        svg += drawn(view, path);
        if (!view.name.empty())
            svg += "<text class=\"name\"" + attribute("x", view.left + 10) +
                   attribute("y", view.top + 20) + '>' + escape_html(view.name) + "</text>\n";
        svg += "</svg>\n";
    }
    return svg + "</svg>\n";
}

}  // namespace companion
