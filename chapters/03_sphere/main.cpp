// A planet with rings of moons. Beside it, one sphere is seen from farther and farther away, drawn
// with the textbook formula and with the stable one.

#include <app/run.hpp>
#include <rt/canvas.hpp>
#include <rt/fill.hpp>
#include <rt/make_camera.hpp>
#include <rt/nearest_sphere.hpp>
#include <rt/ppm.hpp>
#include <rt/primary_ray.hpp>
#include <sstream>
#include <string>

#include "far_spheres.hpp"
#include "scene.hpp"
#include "show_scene.hpp"

namespace {

using rt::Color, rt::Ray, rt::Real, rt::Vec3;

// The color of the nearest sphere along the ray.
Color trace(const std::vector<rt::SceneSphere>& spheres, const Ray& ray) {
    const auto nearest = rt::nearest_sphere(spheres, ray, {0, rt::infinity});
    if (!nearest) return {};
    const Vec3 point = ray.at(nearest->t);
    if (nearest->number == scene::sky_number) return scene::sky(point);

    const Vec3 to_lamp = rt::normalize({Real(-0.62), Real(0.62), Real(0.48)});
    const rt::SceneSphere& sphere = spheres[nearest->number];
    const Real distance = scene::lamp_distance(sphere.shape, point, to_lamp);
    if (nearest->number == scene::planet_number)
        return rt::mix(scene::ramp(distance), scene::ramp(scene::bands(distance, 14)), Real(0.6));
    return scene::lit(scene::moon_color(sphere.material), distance);
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const auto spheres = scene::spheres();
    if (!settings.show.empty()) return scene::show(settings, progress, spheres);

    const far_spheres::Panels panels{settings.height};
    const int left = panels.left(settings.width);
    rt::Image image = rt::Canvas<rt::Color>{settings.width, settings.height, far_spheres::paper};
    app::Figure figure{image};
    const auto camera = rt::make_camera(*settings.view, left, settings.height);
    progress.start(settings.height);
    app::fill(
        figure.part(app::pixel_box(0, 0, left, settings.height)),
        [&](int x, int y) {
            return trace(spheres, rt::primary_ray(camera, x, y, {Real(0.5), Real(0.5)}));
        },
        &progress);
    if (left < settings.width) panels.draw(figure, left);
    const auto pixels =
        static_cast<std::uint64_t>(settings.width) * static_cast<std::uint64_t>(settings.height);
    return {std::move(image), pixels};
}

std::string encode_ppm(const rt::Image& image) {
    std::ostringstream out;
    rt::write_ppm(out, image);
    return out.str();
}

}  // namespace

int main(int argc, char** argv) {
    return app::run(
        argc, argv,
        {.name = "03_sphere",
         .about = "A planet with rings of moons, and one sphere seen from ever farther away.",
         .defaults = {.width = 1280,
                      .height = 720,
                      .seed = {},
                      .view = rt::View{.from = {0, Real(0.75), 6},
                                       .at = {Real(0.02), 0, 0},
                                       .vertical_fov = rt::radians(33)}},
         .render = render,
         .study = app::program_study,
         .encode_ppm = encode_ppm,
         .shows = rt::shown_of_hits()});
}
