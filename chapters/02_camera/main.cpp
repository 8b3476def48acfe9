// Eight cameras at the same place, under the same dome: what the field of view, the point to look
// at and the up vector change.

#include <algorithm>
#include <app/lettering.hpp>
#include <app/run.hpp>
#include <array>
#include <cmath>
#include <rt/make_camera.hpp>
#include <rt/primary_ray.hpp>
#include <string_view>

#include "dome.hpp"
#include "study.hpp"

namespace {

using rt::Color;
using rt::Real;
using rt::Vec2;
using rt::Vec3;

struct Panel {
    std::string_view caption;
    rt::View view;
};

constexpr int columns = 4, rows = 2;
constexpr std::size_t index(int k) {
    return static_cast<std::size_t>(k);
}

// The upper row changes the field of view alone; the lower row changes one thing of the third
// panel.
std::array<Panel, columns * rows> panels() {
    const Vec3 eye{0, Real(1.7), 0};
    const auto view = [&](Vec3 direction, Real fov_deg, Vec3 up = {0, 1, 0}) {
        return rt::View{eye, eye + direction, up, rt::radians(fov_deg)};
    };
    const Vec3 south = dome::toward(180, 7);
    const Vec3 tilted{std::sin(rt::radians(25)), std::cos(rt::radians(25)), 0};
    return {{{"FOV 20*", view(south, 20)},
             {"FOV 50*", view(south, 50)},
             {"FOV 90*", view(south, 90)},
             {"FOV 140*", view(south, 140)},
             {"LEFT 90*", view(dome::toward(90, 7), 90)},
             {"UP 40*", view(dome::toward(180, 47), 90)},
             {"ROLL 25*", view(south, 90, tilted)},
             {"STRAIGHT UP", view({0, 1, 0}, 90)}}};
}

// The pixels of one panel along one axis.
struct Span {
    int begin = 0, size = 1;
};

// Part i of n of so many pixels, less a gutter where there is room for one. In an image with fewer
// pixels than parts some are never shown.
Span part(int pixels, int i, int n) {
    const auto edge = [&](std::int64_t k) { return static_cast<int>(k * pixels / n); };
    const int size = std::max(edge(i + 1) - edge(i), 1), gutter = std::clamp((size - 1) / 2, 0, 2);
    return {edge(i) + gutter, size - 2 * gutter};
}

// The last part that does not begin after pixel x, counting the gutter before it.
int part_at(int pixels, int x, int n) {
    int i = n - 1;
    while (static_cast<std::int64_t>(i) * pixels / n > x) --i;
    return i;
}

Color with_caption(Color color, std::string_view caption, Real x, Real y, int panel_height) {
    const Real height = static_cast<Real>(panel_height), unit = height / 90;  // of the letters
    const Vec2 p{x / unit - 3, (y - height) / unit + 7};
    const Real distance = app::distance_to_text(p, caption) * unit;
    const Real shadow = std::exp(-distance * distance / (9 * unit * unit));
    color = mix(color, {}, Real(0.5) * shadow);
    return mix(color, {1, 1, 1}, dome::coverage(distance, Real(0.75) * unit, 1));
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const auto sheet = panels();
    std::array<rt::Camera, columns * rows> cameras;
    for (int k = 0; k < columns * rows; ++k)
        cameras[index(k)] =
            rt::make_camera(sheet[index(k)].view, part(settings.width, k % columns, columns).size,
                            part(settings.height, k / columns, rows).size);
    std::uint64_t rays = 0;
    rt::Image image = app::draw(settings, progress, [&](int x, int y) {
        const int i = part_at(settings.width, x, columns), j = part_at(settings.height, y, rows);
        const Span across = part(settings.width, i, columns), down = part(settings.height, j, rows);
        const int column = x - across.begin, row = y - down.begin;
        if (column < 0 || column >= across.size || row < 0 || row >= down.size)
            return rt::from_hex(0xf4f1ea);

        const Panel& panel = sheet[index(j * columns + i)];
        const rt::Camera& camera = cameras[index(j * columns + i)];
        const Real half = Real(0.5);
        const dome::Beam beam{primary_ray(camera, column, row, {half, half}),
                              primary_ray(camera, column + 1, row, {half, half}),
                              primary_ray(camera, column, row + 1, {half, half})};
        rays += 3;
        return with_caption(dome::look(beam), panel.caption, static_cast<Real>(column) + half,
                            static_cast<Real>(row) + half, down.size);
    });
    return {image, rays};
}

}  // namespace

int main(int argc, char** argv) {
    return app::run(
        argc, argv,
        {.name = "02_camera",
         .about =
             "one dome of sky through eight cameras: field of view, look-at point and up vector",
         .defaults = {},
         .render = render,
         .study = camera_study::run});
}
