// Chapter 05: metal, glass, and a strip that compares two formulas for how much glass reflects.

#include <app/lettering.hpp>
#include <app/run.hpp>
#include <rt/counting_world.hpp>
#include <rt/make_camera.hpp>
#include <rt/render_pixel.hpp>

#include "scene.hpp"
#include "study.hpp"

namespace {

using namespace rt;

// The strip's glass balls stand in an evening that has a tiled floor: all that matters there is the
// direction of a ray.
struct TiledEvening {
    scene::EveningSky sky;

    Color operator()(Vec3 d) const {
        if (d.y >= Real(-0.06)) return sky(d);
        const Real x = d.x / -d.y, z = d.z / -d.y;  // where it meets a floor 1 below
        return scene::even_tile(x, z) ? from_hex(0xe9dfd2) : from_hex(0x4b5568);
    }
};

// The light along a ray among glass balls, without chance: at each surface both ways are followed,
// and each counts by its share.
template <class Reflectance>
Color light_through_glass(const Ray& ray, const SphereList& balls,
                          const std::array<Real, 3>& indices, Reflectance reflectance, int depth,
                          std::uint64_t& rays) {
    const TiledEvening surroundings;
    const auto hit = CountingWorld<SphereList>{balls, rays}.hit(ray, Interval{0, infinity});
    if (!hit || depth == 0) return surroundings(ray.direction);
    const Real index = indices[static_cast<std::size_t>(hit->material)];
    const Real eta = hit->front ? 1 / index : index;
    const Vec3 normal = facing_normal(*hit);
    const auto along = [&](Vec3 direction) {
        return light_through_glass({leave_surface(*hit, direction), direction}, balls, indices,
                                   reflectance, depth - 1, rays);
    };
    const Real reflected = reflectance(-dot(ray.direction, normal), eta);
    const Color mirror = reflected * along(reflect(ray.direction, normal));
    const auto refracted = refract(ray.direction, normal, eta);
    return refracted ? mirror + (1 - reflected) * along(*refracted) : mirror;
}

// A panel of the strip: 0 has Schlick's formula, 1 the exact one, 2 the difference, times 20: gold
// where Schlick's is too bright, blue where it is too dark.
Color panel_color(int panel, const Ray& ray, std::uint64_t& rays) {
    const std::array<Real, 3> indices{Real(1.1), Real(1.5), Real(2.4)};
    SphereList balls;
    for (int i = 0; i < 3; ++i)
        balls.spheres.push_back({{{Real(2.3) * static_cast<Real>(i - 1), 0, 0}, 1}, i});
    const auto with = [&](auto reflectance) {
        return light_through_glass(ray, balls, indices, reflectance, 6, rays);
    };
    if (panel == 0) return with(schlick_reflectance);
    if (panel == 1) return with(fresnel_reflectance);
    const Color difference = with(schlick_reflectance) - with(fresnel_reflectance);
    const Real amplified = 20 * (difference.r + difference.g + difference.b) / 3;
    return amplified > 0 ? amplified * from_hex(0xf2b84b) : -amplified * from_hex(0x5b8ff0);
}

// A panel's color with its name at the top left: dark on the sky, light on black. (x, y) are pixels
// of the panel.
Color with_name(Color color, int panel, Real x, Real y, int panel_height) {
    constexpr std::string_view names[] = {"SCHLICK", "EXACT", "DIFFERENCE TIMES 20"};
    const Real unit = static_cast<Real>(panel_height) / 64;  // a quarter of a letter
    if (unit < Real(0.75) || y > 8 * unit) return color;     // too small to read, or below
    const Real distance = unit * app::distance_to_text({x / unit - 4, y / unit - 3}, names[panel]);
    return mix(color, panel == 2 ? from_hex(0xe8e4da) : from_hex(0x3b3348),
               std::clamp(Real(0.36) * unit + Real(0.5) - distance, Real(0), Real(1)));
}

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    const scene::Scene evening = scene::evening();
    std::uint64_t rays = 0;
    const CountingWorld<SphereList> world{evening.world, rays};
    const Quality quality{settings.spp, settings.depth, *settings.seed};

    // The strip takes the lower part of the picture, and each panel a third of its width.
    const int strip_height = settings.height * 5 / 18, view_height = settings.height - strip_height;
    const Camera camera =
        make_camera({{0, Real(2.9), 12}, {0, Real(0.85), 0}, {0, 1, 0}, radians(19)},
                    settings.width, view_height);
    const int panel_width = std::max(1, settings.width / 3);
    const Camera panel_camera =
        make_camera({{0, Real(0.6), 14}, {}, {0, 1, 0}, radians(Real(12.8))}, panel_width,
                    std::max(1, strip_height));

    auto image = app::draw(settings, progress, [&](int x, int y) {
        if (y < view_height)
            return render_pixel(camera, world, evening.set, scene::EveningSky{}, SkyEnding{},
                                quality, x, y);
        const int panel = std::min(x / panel_width, 2);
        if (panel > 0 && x - panel * panel_width < settings.width / 320) return Color{};
        Rng random = pixel_rng(quality.seed, x, y);
        const Color color =
            pixel_average(std::min(9, quality.samples_per_pixel), random, [&](Vec2 offset) {
                return panel_color(
                    panel,
                    primary_ray(panel_camera, x - panel * panel_width, y - view_height, offset),
                    rays);
            });
        return with_name(color, panel, static_cast<Real>(x - panel * panel_width) + Real(0.5),
                         static_cast<Real>(y - view_height) + Real(0.5), strip_height);
    });
    return {std::move(image), rays};
}

}  // namespace

int main(int argc, char** argv) {
    app::Settings defaults;
    defaults.spp = 64;
    defaults.depth = 12;
    defaults.seed = 5;
    return app::run(
        argc, argv,
        {.name = "05_metal_glass",
         .about = "metal at five fuzz values, glass, hollow glass, and two formulas for "
                  "what glass reflects",
         .defaults = defaults,
         .render = render,
         .study = metal_glass_study::run});
}
