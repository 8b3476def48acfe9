// A planet with rings of moons; beside it one sphere seen from farther and farther away, by the
// formula of the textbook and by the stable one.

#include <app/lettering.hpp>
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

// One of the small pictures: a sphere of radius 1 this far away always fills the same angle.
class Panel {
  public:
    Panel(Real distance, int side, variants::HitFunction hit)
        : sphere_{distance / 7 * Vec3{2, 3, -6}, 1},
          camera_{rt::make_camera(
              {.at = sphere_.center, .vertical_fov = 2 * std::atan(Real(1.3) / distance)}, side,
              side)},
          hit_{hit} {}

    Color shade(int x, int y) const {
        const Ray ray = rt::primary_ray(camera_, x, y, {Real(0.5), Real(0.5)});
        const auto t = hit_(sphere_, ray, {0, rt::infinity});
        if (!t) return rt::from_hex(0x0b0e1f);
        const Vec3 to_lamp = camera_.basis.to_world({Real(-0.48), Real(0.48), Real(0.73)});
        const Real distance = scene::lamp_distance(sphere_, ray.at(*t), to_lamp);
        return scene::ramp(scene::bands(distance, 14));
    }

  private:
    Sphere sphere_;
    rt::Camera camera_;
    variants::HitFunction hit_;
};

// Powers of ten around 1 / sqrt(epsilon), where the textbook's formula loses the sphere.
constexpr int exponents[] = {1, std::is_same_v<Real, float> ? 3 : 7,
                             std::is_same_v<Real, float> ? 4 : 8,
                             std::is_same_v<Real, float> ? 5 : 9};

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    // The panels stand on the right, two columns by four rows under a line of words; a picture that
    // is too small for them shows the planet alone.
    const int gap = settings.height / 60, dot = std::max(1, settings.height / 360);
    const int top = 7 * dot + gap, side = (settings.height - top - 4 * gap) / 4;
    const bool has_panels = gap > 0 && side > 0 && settings.width > 4 * (side + gap);
    const int left = has_panels ? settings.width - 2 * (side + gap) - gap : settings.width;

    const auto bodies = scene::bodies();
    const auto camera = rt::make_camera(
        {.from = {0, Real(0.75), 6}, .at = {Real(0.02), 0, 0}, .vertical_fov = rt::radians(33)},
        left, settings.height);
    std::vector<Panel> panels;
    for (const int exponent : exponents)
        for (const auto hit : {variants::textbook, rt::hit_sphere})
            if (has_panels)
                panels.emplace_back(std::pow(Real(10), static_cast<Real>(exponent)), side, hit);

    const auto shade = [&](int x, int y) {
        if (x < left) return trace(bodies, rt::primary_ray(camera, x, y, {Real(0.5), Real(0.5)}));
        const Color paper = rt::from_hex(0x05060f), ink = rt::from_hex(0xb8bfdc);
        const int column = (x - left - gap) / (side + gap), u = (x - left - gap) % (side + gap);
        // How much of the pixel a text covers whose first letter starts so many pixels away.
        const auto word = [&](std::string_view text, int right, int down) {
            const auto unit = static_cast<Real>(dot);
            const rt::Vec2 place{static_cast<Real>(right) / unit, static_cast<Real>(down) / unit};
            const Real distance = app::distance_to_text(place, text) * unit;
            return std::clamp(Real(0.3) * unit + Real(0.5) - distance, Real(0), Real(1));
        };
        if (x - left < gap || column > 1) return paper;
        if (y < top) return mix(paper, ink, word(column ? "STABLE" : "TEXTBOOK", u, y - gap));
        const int row = (y - top) / (side + gap), v = (y - top) % (side + gap);
        if (row > 3 || u >= side || v >= side) return paper;
        const int base = v - (side - 7 * dot);
        const Real label =
            std::max(word("10", u - 3 * dot, base),
                     word(std::to_string(exponents[row]), u - 10 * dot, base + 3 * dot));
        return mix(panels[static_cast<std::size_t>(2 * row + column)].shade(u, v), ink, label);
    };
    const auto pixels =
        static_cast<std::uint64_t>(settings.width) * static_cast<std::uint64_t>(settings.height);
    return {app::draw(settings, progress, shade), pixels};
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
