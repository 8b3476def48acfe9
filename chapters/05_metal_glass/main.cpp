// Chapter 05: metal, glass, and a strip that compares two formulas for how much glass reflects.

#include <app/run.hpp>
#include <rt/canvas.hpp>
#include <rt/counting_world.hpp>
#include <rt/fill.hpp>
#include <rt/make_camera.hpp>
#include <rt/render_pixel.hpp>
#include <rt/show_paths.hpp>

#include "glass_strip.hpp"
#include "scene.hpp"

namespace {

using namespace rt;

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const scene::Scene evening = scene::evening();
    const int strip_height = settings.height * 5 / 18, view_height = settings.height - strip_height;
    if (!settings.show.empty())
        return show_paths(settings, progress, evening.world, evening.set, scene::EveningSky{},
                          SkyEnding{});
    std::uint64_t rays = 0;
    const CountingWorld<SphereList> world{evening.world, rays};
    const Quality quality{settings.spp, settings.depth, *settings.seed};

    // The strip takes the lower part of the picture, and each panel a third of its width.
    Image image = Canvas<Color>{settings.width, settings.height};
    app::Figure figure{image};
    const int panel_width = std::max(1, settings.width / 3);
    progress.start(view_height + 3 * strip_height);

    app::Figure view = figure.part(app::pixel_box(0, 0, settings.width, view_height));
    const Camera camera = make_camera(*settings.view, view.columns(), view.rows());
    app::fill(
        view,
        [&](int x, int y) {
            return render_pixel(camera, world, evening.set, scene::EveningSky{}, SkyEnding{},
                                quality, x, y);
        },
        &progress);

    const Camera panel_camera =
        make_camera({{0, Real(0.6), 14}, {}, {0, 1, 0}, radians(Real(12.8))}, panel_width,
                    std::max(1, strip_height));
    constexpr std::string_view names[] = {"Schlick", "Exact", "Difference times 20"};
    for (int i = 0; i < 3; ++i) {
        const int left = i * panel_width, right = i < 2 ? left + panel_width : settings.width;
        app::Figure panel =
            figure.part(app::pixel_box(left, view_height, right - left, strip_height));
        app::fill(
            panel,
            [&](int x, int y) {
                Rng random = pixel_rng(quality.seed, left + x, view_height + y);
                return pixel_average(
                    std::min(9, quality.samples_per_pixel), random, [&](Vec2 offset) {
                        return scene::panel_color(i, primary_ray(panel_camera, x, y, offset), rays);
                    });
            },
            &progress);
        if (i > 0) panel.box(app::pixel_box(0, 0, settings.width / 320, strip_height), {});
        // Dark letters on the sky, light letters on black.
        const Real letter = static_cast<Real>(strip_height) / 16;
        panel.words({letter, Real(0.75) * letter}, names[i],
                    {letter, from_hex(i == 2 ? 0xe8e4da : 0x3b3348)});
    }
    return {std::move(image), rays};
}

}  // namespace

int main(int argc, char** argv) {
    app::Settings defaults;
    defaults.spp = 64;
    defaults.depth = 12;
    defaults.seed = 5;
    defaults.view = View{{0, Real(2.9), 12}, {0, Real(0.85), 0}, {0, 1, 0}, radians(19)};
    return app::run(
        argc, argv,
        {.name = "05_metal_glass",
         .about = "metal at five fuzz values, glass, hollow glass, and two formulas for "
                  "what glass reflects",
         .defaults = defaults,
         .render = render,
         .study = app::program_study,
         .shows = rt::shown_of_paths()});
}
