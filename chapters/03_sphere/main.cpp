// A planet with rings of moons; beside it one sphere seen from farther and farther away, by the
// formula of the textbook and by the stable one.

#include <app/figure.hpp>
#include <app/run.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/make_camera.hpp>
#include <rt/ppm.hpp>
#include <rt/primary_ray.hpp>
#include <sstream>
#include <string>
#include <type_traits>

#include "scene.hpp"
#include "study.hpp"
#include "variants.hpp"

namespace {

using rt::Color, rt::Interval, rt::Ray, rt::Real, rt::Sphere, rt::Vec3;

const Color paper = rt::from_hex(0x05060f), ink = rt::from_hex(0xb8bfdc);

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

// A sphere of radius 1 from this far away: it always fills the same angle.
void draw_far_sphere(app::Figure panel, Real distance, variants::HitFunction hit) {
    const Sphere sphere{distance / 7 * Vec3{2, 3, -6}, 1};
    const rt::Camera camera =
        rt::make_camera({.at = sphere.center, .vertical_fov = 2 * std::atan(Real(1.3) / distance)},
                        panel.columns(), panel.rows());
    const Vec3 to_lamp = camera.basis.to_world({Real(-0.48), Real(0.48), Real(0.73)});
    panel.fill([&](int x, int y) {
        const Ray ray = rt::primary_ray(camera, x, y, {Real(0.5), Real(0.5)});
        const auto t = hit(sphere, ray, {0, rt::infinity});
        if (!t) return rt::from_hex(0x0b0e1f);
        return scene::ramp(scene::bands(scene::lamp_distance(sphere, ray.at(*t), to_lamp), 14));
    });
}

// Powers of ten around 1 / sqrt(epsilon), where the textbook's formula loses the sphere.
constexpr int exponents[] = {1, std::is_same_v<Real, float> ? 3 : 7,
                             std::is_same_v<Real, float> ? 4 : 8,
                             std::is_same_v<Real, float> ? 5 : 9};

// The small pictures beside the planet: two columns of four under a line of words. All in pixels.
struct Panels {
    int gap, dot, top, side;  // letters are made of dots

    explicit Panels(int height)
        : gap{height / 60},
          dot{std::max(1, height / 360)},
          top{7 * dot + gap},
          side{(height - top - 4 * gap) / 4} {}

    // What is left of the width for the planet. Where there is no room for panels it gets all.
    int left(int width) const {
        const bool have_room = gap > 0 && side > 0 && width > 4 * (side + gap);
        return have_room ? width - 2 * (side + gap) - gap : width;
    }

    void draw(app::Figure& figure, int left) const {
        const auto pixels = [](int n) { return static_cast<Real>(n); };
        const auto place = [&](int x, int y) {
            return rt::Vec2{pixels(x) + Real(0.5), pixels(y) + Real(0.5)};
        };
        const app::Lettering letters{pixels(4 * dot), ink, Real(0.3)};
        for (int column = 0; column < 2; ++column) {
            const int x = left + gap + column * (side + gap);
            figure.part(app::pixel_box(x, 0, side, top))
                .words(place(0, gap), column ? "STABLE" : "TEXTBOOK", letters);
            for (int row = 0; row < 4; ++row) {
                app::Figure panel =
                    figure.part(app::pixel_box(x, top + row * (side + gap), side, side));
                draw_far_sphere(panel, std::pow(Real(10), pixels(exponents[row])),
                                column ? rt::hit_sphere : variants::textbook);
                panel.words(place(3 * dot, side - 7 * dot), "10", letters);
                panel.words(place(10 * dot, side - 10 * dot), std::to_string(exponents[row]),
                            letters);
            }
        }
    }
};

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const Panels panels{settings.height};
    const int left = panels.left(settings.width);
    rt::Image image{settings.width, settings.height, paper};
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
