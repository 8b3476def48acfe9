// Eight cameras at the same place, under the same dome: what the field of view, the point to look
// at and the up vector change.

#include <app/run.hpp>
#include <rt/canvas.hpp>
#include <rt/fill.hpp>
#include <rt/make_camera.hpp>
#include <rt/portable.hpp>
#include <rt/primary_ray.hpp>
#include <rt/show.hpp>
#include <string_view>

#include "dome.hpp"
#include "panels.hpp"

namespace {

using rt::Color;
using rt::Real;

// The words have a soft shadow, which makes them readable on any background.
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

// The direction of each pixel's ray, in false colors.
app::Picture show(const app::Settings& settings, app::Progress& progress) {
    const auto all = panels::all();
    return app::show(settings, progress, [&](int x, int y) -> rt::Shown {
        const int column = panels::part_of(x, settings.width, panels::columns),
                  row = panels::part_of(y, settings.height, panels::rows);
        const panels::Span across = panels::part(settings.width, column, panels::columns),
                           down = panels::part(settings.height, row, panels::rows);
        const rt::View& view = all[static_cast<std::size_t>(row * panels::columns + column)].view;
        return primary_ray(rt::make_camera(view, across.size, down.size), x - across.begin,
                           y - down.begin, {Real(0.5), Real(0.5)})
            .direction;
    });
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    if (!settings.show.empty()) return show(settings, progress);

    rt::Image image =
        rt::Canvas<rt::Color>{settings.width, settings.height, rt::from_hex(0xf4f1ea)};
    app::Figure figure{image};
    progress.start(panels::rows);
    std::uint64_t rays = 0;
    int k = 0;
    for (const auto& [caption, view] : panels::all()) {
        const int column = k % panels::columns, row = k++ / panels::columns;
        const panels::Span across = panels::part(settings.width, column, panels::columns),
                           down = panels::part(settings.height, row, panels::rows);
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
        if (column == panels::columns - 1) progress.step();
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
         .study = app::program_study,
         .shows = rt::shown_of_rays()});
}
