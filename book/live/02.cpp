// The live figures of chapter 02.
#include <rt/make_camera.hpp>
#include <rt/primary_ray.hpp>

#include "controls.hpp"
#include "dome.hpp"
#include "live.hpp"
#include "space.hpp"

namespace live {
namespace {

// ---- Looking around under the dome ----

double dome_height(double width) {
    return width * (width < 520 ? 0.8 : 0.54);
}

}  // namespace

void draw(const DomeControls& c, Drawing& out) {
    out.height = dome_height(out.width);
    const int columns = static_cast<int>(std::min(out.width * out.pixel_ratio, 860.0)),
              rows = static_cast<int>(columns * out.height / out.width);
    const rt::Vec3 eye{0, 1.7, 0}, ahead = dome::toward(c.azimuth, c.elevation);
    // What is above in the picture before the camera rolls, even if it looks straight up.
    const rt::Vec3 above = dome::toward(c.azimuth, c.elevation + 90),
                   right = dome::toward(c.azimuth + 90, 0);
    const double roll = rt::radians(c.roll);
    const rt::Camera camera = rt::make_camera(
        {eye, eye + ahead, std::cos(roll) * above + std::sin(roll) * right, rt::radians(c.fov)},
        columns, rows);
    out.refine(
        {0, 0}, {out.width, out.height}, columns, rows, 1, [camera](int column, int row, int) {
            const auto ray = [&](int x, int y) { return primary_ray(camera, x, y, {0.5, 0.5}); };
            return dome::look({ray(column, row), ray(column + 1, row), ray(column, row + 1)});
        });
    out.handle_everywhere();
    const double h = camera.viewport.height;
    out.say("At distance 1, the viewport is {} high and {} wide.", h, camera.viewport.width);
}

void drag(DomeControls& c, const Drag& to) {
    // How many degrees a pixel in the middle of the picture covers.
    const double degrees =
        2 * std::tan(rt::radians(c.fov) / 2) / dome_height(to.width) / rt::radians(1);
    c.azimuth = std::fmod(
        c.azimuth - degrees * to.moved().x / std::max(0.2, std::cos(rt::radians(c.elevation))) +
            720,
        360);
    c.elevation += degrees * to.moved().y;
}

// ---- The ray of a pixel ----

namespace {

constexpr int pixel_columns = 8, pixel_rows = 6;

struct PixelLayout {
    Point space;  // the middle of the drawing of space
    double scale;
    Point corner;  // of the viewport as the eye sees it
    double pixel, height;
};

PixelLayout pixel_layout(double width) {
    if (width < 520) {
        const double pixel = 0.09 * width;
        return {{0.5 * width, 0.36 * width},
                width / 4.4,
                {(width - pixel_columns * pixel) / 2, 0.74 * width},
                pixel,
                1.28 * width + 42};
    }
    const double pixel = 0.042 * width;
    return {{0.31 * width, 0.25 * width},
            width / 5.8,
            {width - pixel_columns * pixel - 14, 0.11 * width},
            pixel,
            0.47 * width};
}

// What the camera sees: a target, on a wall behind the viewport.
constexpr double wall = -2.6;
constexpr int rings = 3;
constexpr double ring_width = 0.22;
const rt::Vec3 target{0.55, 0.35, wall};

rt::Vec3 on_wall(const rt::Ray& ray) {
    return ray.at((wall - ray.origin.z) / ray.direction.z);
}

// Which ring a ray meets, counted from the middle; `rings` if it misses the target.
int ring(const rt::Ray& ray) {
    const rt::Vec3 p = on_wall(ray);
    return static_cast<int>(
        std::min(double(rings), std::hypot(p.x - target.x, p.y - target.y) / ring_width));
}
constexpr Ink ring_inks[] = {rgb(0xd8432f), rgb(0xfff4e6), rgb(0xd8432f)};

// What both panels show.
struct ChosenPixel {
    rt::Camera camera;
    rt::Vec2 place;  // in pixels from the viewport's top left corner
    int column, row;
    rt::Vec2 offset;
    rt::Ray ray;

    explicit ChosenPixel(const PixelControls& c)
        : camera{rt::make_camera({{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, rt::radians(c.fov)},
                                 pixel_columns, pixel_rows)},
          place{c.x, c.y},
          column{std::min(static_cast<int>(c.x), pixel_columns - 1)},
          row{std::min(static_cast<int>(c.y), pixel_rows - 1)},
          offset{c.x - column, c.y - row},
          ray{primary_ray(camera, column, row, offset)} {}

    rt::Vec3 on_viewport(double x, double y) const {
        const rt::Vec2 p = pixel_to_viewport(camera, 0, 0, {x, y});
        return {p.x, p.y, -1};
    }
};

void draw_target(const Space& space, Drawing& out) {
    for (int i = rings; i-- > 0;) {
        std::vector<Point> rim;
        for (int k = 0; k < 48; ++k) {
            const double angle = 2 * rt::pi * k / 48, radius = (i + 1) * ring_width;
            rim.push_back(space.to_page(
                target + rt::Vec3{radius * std::cos(angle), radius * std::sin(angle), 0}));
        }
        out.polygon(rim, ring_inks[i]);
    }
}

void draw_viewport(const ChosenPixel& chosen, const Space& space, Drawing& out) {
    const auto corner = [&](int i, int k) { return chosen.on_viewport(i, k); };
    const auto fill = [&](int i, int k, Ink color) {
        out.polygon(
            space.corners({corner(i, k), corner(i + 1, k), corner(i + 1, k + 1), corner(i, k + 1)}),
            color);
    };
    // What each pixel shows: one ray through its middle.
    for (int k = 0; k < pixel_rows; ++k)
        for (int i = 0; i < pixel_columns; ++i) {
            const int shows = ring(primary_ray(chosen.camera, i, k, {0.5, 0.5}));
            fill(i, k, shows < rings ? thin(ring_inks[shows], 0.75) : thin(accent, 0.1));
        }
    const auto line = [&](rt::Vec3 from, rt::Vec3 to, Pen stroke) {
        out.line(space.to_page(from), space.to_page(to), stroke);
    };
    for (int i = 0; i <= pixel_columns; ++i)
        line(corner(i, 0), corner(i, pixel_rows), {thin(accent, 0.6), 1});
    for (int k = 0; k <= pixel_rows; ++k)
        line(corner(0, k), corner(pixel_columns, k), {thin(accent, 0.6), 1});
    fill(chosen.column, chosen.row, thin(amber, 0.7));
    for (const int i : {0, pixel_columns})
        for (const int k : {0, pixel_rows}) line({0, 0, 0}, corner(i, k), {muted, 1, 4});
}

// The eye, the viewport and the target, from the side.
void draw_space(const ChosenPixel& chosen, const Space& space, Drawing& out) {
    const Point eye = space.to_page(rt::Vec3{0, 0, 0}), end = space.to_page(on_wall(chosen.ray)),
                through = space.to_page(chosen.on_viewport(chosen.place.x, chosen.place.y));
    // What is farther away comes first.
    if (space.toward(target) < space.toward({0, 0, -1})) {
        draw_target(space, out);
        out.arrow(through, end, {ink, 2.5});
        draw_viewport(chosen, space, out);
        out.line(eye, through, {ink, 2.5});
    } else {
        draw_viewport(chosen, space, out);
        out.arrow(eye, end, {ink, 2.5});
        draw_target(space, out);
    }
    out.dot(end, ink, 4);
    out.dot(through, amber, 4);

    const auto axis = [&](rt::Vec3 along, std::string_view name, Ink color) {
        out.arrow(eye, space.to_page(0.6 * along), {color, 2.5});
        out.bold = true;
        out.text(space.to_page(0.75 * along), name, color);
        out.bold = false;
    };
    axis(chosen.camera.basis.u, "u", orange);
    axis(chosen.camera.basis.v, "v", green);
    axis(chosen.camera.basis.w, "w", blue);
    out.dot(eye, ink, 5);
    out.text(eye + Point{0, 18}, "eye", ink);
    out.text(space.to_page(chosen.on_viewport(pixel_columns / 2.0, pixel_rows)) + Point{14, 24},
             "viewport", muted);
}

// The viewport as the eye sees it, sharp: many rays a pixel.
void draw_seen(const ChosenPixel& chosen, const PixelLayout& layout, Drawing& out) {
    const auto at = [&](double x, double y) { return layout.corner + layout.pixel * Point{x, y}; };
    const Point corner = layout.corner, opposite = at(pixel_columns, pixel_rows);
    constexpr int fine = 16;
    Bytes& seen = out.picture(fine * pixel_columns, fine * pixel_rows);
    for (int y = 0; y < seen.rows; ++y)
        for (int x = 0; x < seen.columns; ++x) {
            const int shows = ring(primary_ray(chosen.camera, x / fine, y / fine,
                                               {(x % fine + 0.5) / fine, (y % fine + 0.5) / fine}));
            seen.set(x, y,
                     rt::from_hex(shows == rings ? 0xc9dcf3
                                  : shows == 1   ? 0xfff4e6
                                                 : 0xd8432f));
        }
    out.show(seen, corner, opposite);
    const Pen grid{thin(rgb(0x24406e), 0.35), 1};
    for (int i = 0; i <= pixel_columns; ++i) out.line(at(i, 0), at(i, pixel_rows), grid);
    for (int k = 0; k <= pixel_rows; ++k) out.line(at(0, k), at(pixel_columns, k), grid);
    out.frame(at(chosen.column, chosen.row), at(chosen.column + 1, chosen.row + 1), {amber, 3});
    const double middle = (corner.x + opposite.x) / 2;
    out.text({middle, corner.y - 14}, "the viewport, seen from the eye", muted);
    out.handle(at(chosen.place.x, chosen.place.y));

    const rt::Vec2 p = pixel_to_viewport(chosen.camera, chosen.column, chosen.row, chosen.offset);
    const double line = out.is_narrow() ? 18 : 20;
    const Point words{middle, opposite.y + line};
    out.text(words, "x = {.3}, y = {.3}", ink, Align::middle, p.x, p.y);
    out.text(words + Point{0, line}, "x u + y v − w", muted);
}

}  // namespace

void draw(const PixelControls& c, Drawing& out) {
    const PixelLayout layout = pixel_layout(out.width);
    out.height = layout.height;
    const ChosenPixel chosen{c};
    draw_space(chosen, {layout.space, {0, 0, -1.35}, c.turn, c.up, layout.scale}, out);
    out.handle_everywhere();
    draw_seen(chosen, layout, out);
    const rt::Vec3 direction = chosen.ray.direction;
    out.say(
        "Column {}, row {}, offset ({.2}, {.2}): the ray’s direction, normalized, is ({.3}, {.3}, "
        "{.3}).",
        chosen.column, chosen.row, chosen.offset.x, chosen.offset.y, direction.x, direction.y,
        direction.z);
}

void drag(PixelControls& c, const Drag& to) {
    const PixelLayout layout = pixel_layout(to.width);
    const Point place = layout.corner + layout.pixel * Point{c.x, c.y};
    const Point opposite = layout.corner + layout.pixel * Point{pixel_columns, pixel_rows};
    const bool inside = to.down.x > layout.corner.x && to.down.x < opposite.x &&
                        to.down.y > layout.corner.y && to.down.y < opposite.y;
    if (distance(place, to.down) < 20 || inside) {
        const Point start = distance(place, to.down) < 20 ? place : to.down;
        const Point now = (1 / layout.pixel) * (start + to.moved() - layout.corner);
        c.x = now.x, c.y = now.y;
    } else {
        c.turn -= 180 * to.moved().x / to.width;
        c.up += 180 * to.moved().y / to.width;
    }
}

}  // namespace live
