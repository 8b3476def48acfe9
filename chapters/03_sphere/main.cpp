// A planet with rings of moons; beside it one sphere seen from farther and farther away, by the
// formula of the textbook and by the stable one.

#include <app/figure.hpp>
#include <app/run.hpp>
#include <rt/canvas.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/make_camera.hpp>
#include <rt/ppm.hpp>
#include <rt/primary_ray.hpp>
#include <sstream>
#include <string>

#include "far_spheres.hpp"
#include "scene.hpp"
#include "study.hpp"

namespace {

using rt::Color, rt::Interval, rt::Ray, rt::Real, rt::Sphere, rt::Vec3;

// The nearest of all bodies along the ray. Each hit shortens the interval, so that only what lies
// in front of it can still be found.
Color trace(const std::vector<scene::Body>& bodies, const Ray& ray) {
    static const Sphere sky{{0, 0, 0}, 1000};  // the camera is inside of it
    Interval within{0, rt::infinity};
    Color color{0, 0, 0};
    if (const auto t = rt::hit_sphere(sky, ray, within)) {
        color = scene::sky(ray.at(*t));
        within.max = *t;
    }
    const Vec3 to_lamp = rt::normalize({Real(-0.62), Real(0.62), Real(0.48)});
    for (const scene::Body& body : bodies)
        if (const auto t = rt::hit_sphere(body.sphere, ray, within)) {
            const Real distance = scene::lamp_distance(body.sphere, ray.at(*t), to_lamp);
            const bool planet = &body == bodies.data();
            color = planet ? rt::mix(scene::ramp(distance), scene::ramp(scene::bands(distance, 14)),
                                     Real(0.6))
                           : scene::lit(body.color, distance);
            within.max = *t;
        }
    return color;
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const far_spheres::Panels panels{settings.height};
    const int left = panels.left(settings.width);
    rt::Image image = rt::Canvas<rt::Color>{settings.width, settings.height, far_spheres::paper};
    app::Figure figure{image};

    const auto bodies = scene::bodies();
    const auto camera = rt::make_camera(
        {.from = {0, Real(0.75), 6}, .at = {Real(0.02), 0, 0}, .vertical_fov = rt::radians(33)},
        left, settings.height);
    progress.start(settings.height);
    figure.part(app::pixel_box(0, 0, left, settings.height))
        .fill(
            [&](int x, int y) {
                return trace(bodies, rt::primary_ray(camera, x, y, {Real(0.5), Real(0.5)}));
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
         .defaults = {.width = 1280, .height = 720, .seed = {}},
         .render = render,
         .study = spheres::run_study,
         .encode_ppm = encode_ppm});
}
