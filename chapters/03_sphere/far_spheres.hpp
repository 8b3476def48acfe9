#pragma once
// The small pictures beside the planet: one sphere from farther and farther away, drawn with the
// textbook formula and with the stable one.

#include <rt/fill.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/make_camera.hpp>
#include <rt/portable.hpp>
#include <rt/primary_ray.hpp>
#include <string>
#include <type_traits>

#include "scene.hpp"
#include "variants.hpp"

namespace far_spheres {

using rt::Color, rt::Ray, rt::Real, rt::Sphere, rt::Vec3;

inline const Color paper = rt::from_hex(0x05060f), ink = rt::from_hex(0xb8bfdc);

// A sphere of radius 1 at this distance. The camera's field of view shrinks with the distance, so
// that the sphere always looks equally large.
struct FarSphere {
    Sphere sphere;
    rt::Camera camera;  // at (0, 0, 0)

    FarSphere(Real distance, int columns, int rows)
        : sphere{distance / 7 * Vec3{2, 3, -6}, 1},
          camera{rt::make_camera(
              {.at = sphere.center, .vertical_fov = 2 * rt::portable::atan(Real(1.3) / distance)},
              columns, rows)} {}

    Ray ray(int x, int y) const { return rt::primary_ray(camera, x, y, {Real(0.5), Real(0.5)}); }
    // The color of a ray that hits the sphere at t, or misses it if there is no t.
    Color color(const Ray& ray, std::optional<Real> t) const {
        if (!t) return rt::from_hex(0x0b0e1f);
        const Vec3 to_lamp = camera.basis.to_world({Real(-0.48), Real(0.48), Real(0.73)});
        return scene::ramp(scene::bands(scene::lamp_distance(sphere, ray.at(*t), to_lamp), 14));
    }
};

inline void draw_far_sphere(app::Figure panel, Real distance, variants::HitFunction hit) {
    const FarSphere far{distance, panel.columns(), panel.rows()};
    app::fill(panel, [&](int x, int y) {
        const Ray ray = far.ray(x, y);
        return far.color(ray, hit(far.sphere, ray, {0, rt::infinity}));
    });
}

// The distances are 10 to these powers. The last three distances are around 1 / sqrt(epsilon),
// where the textbook formula loses the sphere.
inline constexpr int exponents[] = {1, std::is_same_v<Real, float> ? 3 : 7,
                                    std::is_same_v<Real, float> ? 4 : 8,
                                    std::is_same_v<Real, float> ? 5 : 9};

// Where the small pictures are: in two columns of four, under a line of words. All sizes are in
// pixels.
struct Panels {
    int gap, dot, top, side;  // a line of words is 7 dots high

    explicit Panels(int height)
        : gap{height / 60},
          dot{std::max(1, height / 360)},
          top{7 * dot + gap},
          side{(height - top - 4 * gap) / 4} {}

    // The width that is left for the planet. If there is no room for the panels, the planet gets
    // the whole width.
    int left(int width) const {
        const bool have_room = gap > 0 && side > 0 && width > 4 * (side + gap);
        return have_room ? width - 2 * (side + gap) - gap : width;
    }

    void draw(app::Figure& figure, int left) const {
        const auto pixels = [](int n) { return static_cast<Real>(n); };
        const auto place = [&](int x, int y) {
            return rt::Vec2{pixels(x) + Real(0.5), pixels(y) + Real(0.5)};
        };
        const app::Lettering letters{Real(6.5) * pixels(dot), ink, Real(0.3)},
            small{5 * pixels(dot), ink, Real(0.3)};
        for (int column = 0; column < 2; ++column) {
            const int x = left + gap + column * (side + gap);
            figure.part(app::pixel_box(x, 0, side, top))
                .words(place(0, gap), column ? "Stable" : "Textbook", letters);
            for (int row = 0; row < 4; ++row) {
                app::Figure panel =
                    figure.part(app::pixel_box(x, top + row * (side + gap), side, side));
                draw_far_sphere(panel, rt::portable::pow(Real(10), pixels(exponents[row])),
                                column ? rt::hit_sphere : variants::textbook);
                panel.words(place(3 * dot, side - 9 * dot), "10", letters);
                panel.words(place(12 * dot, side - 12 * dot), std::to_string(exponents[row]),
                            small);
            }
        }
    }
};

}  // namespace far_spheres
