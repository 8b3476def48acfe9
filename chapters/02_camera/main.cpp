// Eight cameras at the same place, under the same dome: what the field of view, the point to look
// at and the up vector change.

#include <algorithm>
#include <app/run.hpp>
#include <array>
#include <rt/canvas.hpp>
#include <rt/fill.hpp>
#include <rt/make_camera.hpp>
#include <rt/portable.hpp>
#include <rt/primary_ray.hpp>
#include <string_view>

#include "dome.hpp"
#include "study.hpp"

namespace {

using rt::Color;
using rt::Real;
using rt::Vec3;

struct Panel {
    std::string_view caption;
    rt::View view;
};

constexpr int columns = 4, rows = 2;
constexpr std::size_t index(int k) {
    return static_cast<std::size_t>(k);
}

// The upper row changes only the field of view; the lower row changes one thing in the third panel.
std::array<Panel, columns * rows> panels() {
    const Vec3 eye{0, Real(1.7), 0};
    const auto view = [&](Vec3 direction, Real fov_deg, Vec3 up = {0, 1, 0}) {
        return rt::View{eye, eye + direction, up, rt::radians(fov_deg)};
    };
    const Vec3 south = dome::toward(180, 7);
    const Vec3 tilted{rt::portable::sin(rt::radians(25)), rt::portable::cos(rt::radians(25)), 0};
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

// Part i of n of this many pixels, less a gutter if there is room for one. In an image with fewer
// pixels than parts, some parts are never shown.
Span part(int pixels, int i, int n) {
    const auto edge = [&](std::int64_t k) { return static_cast<int>(k * pixels / n); };
    const int size = std::max(edge(i + 1) - edge(i), 1), gutter = std::clamp((size - 1) / 2, 0, 2);
    return {edge(i) + gutter, size - 2 * gutter};
}

// The words stand in a soft shadow, which makes them readable on any background.
void write_caption(app::Figure& panel, std::string_view caption) {
    const Real height = static_cast<Real>(panel.rows()), unit = height / 90;
    const rt::Vec2 corner{3 * unit, height - 7 * unit};
    panel.blend(
        app::pixel_box(0, 0, panel.columns(), panel.rows()),
        [&](rt::Vec2 p) {
            const Real distance =
                app::distance_to_text({(p.x - corner.x) / unit, (p.y - corner.y) / unit}, caption);
            return Real(0.5) * rt::portable::exp(-distance * distance / 9);
        },
        [](rt::Vec2) { return Color{}; });
    panel.words(corner, caption, {4 * unit, {1, 1, 1}, Real(0.375)});
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    rt::Image image =
        rt::Canvas<rt::Color>{settings.width, settings.height, rt::from_hex(0xf4f1ea)};
    app::Figure figure{image};
    progress.start(rows);
    std::uint64_t rays = 0;
    for (int k = 0; k < columns * rows; ++k) {
        const auto [caption, view] = panels()[index(k)];
        const Span across = part(settings.width, k % columns, columns),
                   down = part(settings.height, k / columns, rows);
        app::Figure panel =
            figure.part(app::pixel_box(across.begin, down.begin, across.size, down.size));
        const rt::Camera camera = rt::make_camera(view, panel.columns(), panel.rows());
        app::fill(panel, [&](int x, int y) {
            const rt::Vec2 middle{Real(0.5), Real(0.5)};
            rays += 3;
            return dome::look({primary_ray(camera, x, y, middle),
                               primary_ray(camera, x + 1, y, middle),
                               primary_ray(camera, x, y + 1, middle)});
        });
        write_caption(panel, caption);
        if (k % columns == columns - 1) progress.step();
    }
    return {std::move(image), rays};
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
