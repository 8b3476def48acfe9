#include "final_scene.hpp"

#include <cmath>
#include <iterator>
#include <rt/rng.hpp>
#include <rt/transform.hpp>

#include "placing.hpp"

namespace effects {
namespace {

using namespace rt;

constexpr double lake = 40, wave_length = 6.6;

// How high the lake stands at this distance from where the drop fell.
double ripple(double distance) {
    return 1.5 * std::cos(2 * std::numbers::pi * distance / wave_length) *
           std::exp(-distance / 15) * std::min(1.0, distance / 2.5);
}

}  // namespace

SceneDescription final_scene() {
    SceneDescription scene;
    scene.camera.view.from = {Real(-4), Real(7.8), Real(25)};
    scene.camera.view.at = {Real(4), Real(3.3), 0};
    scene.camera.view.vertical_fov = radians(29);
    scene.camera.lens = {Real(0.34), Real(25)};
    scene.sky = {{Real(1.5), Real(0.58), Real(0.36)}, {Real(0.03), Real(0.09), Real(0.34)}};
    scene.settings.width = 800;
    scene.settings.height = 450;

    const auto material = [&](const MaterialDescription& description) {
        scene.materials.push_back(description);
        return static_cast<int>(scene.materials.size() - 1);
    };
    const auto add = [&](Vec3 center, double radius, int of) {
        scene.spheres.push_back({{center, static_cast<Real>(radius)}, of, {}});
    };

    add({0, -2001, 0}, 2000, material(Metal{{Real(0.30), Real(0.34), Real(0.48)}, Real(0.12)}));

    // The drop, of glass, and the sun behind it.
    const int glass = material(Dielectric{Real(1.5)});
    add({0, Real(2.9), 0}, 2.3, glass);
    add({Real(150), Real(21), -300}, 23, material(Emitter{{Real(3.0), Real(0.95), Real(0.24)}}));
    const auto hill = [&](double x, double z, double radius, double top, std::uint32_t color) {
        add({static_cast<Real>(x), static_cast<Real>(top - radius), static_cast<Real>(z)}, radius, material(Lambertian{from_hex(color)}));
    };
    hill(0, -320, 170, 21, 0x8d6685);
    hill(262, -310, 150, 19, 0x8d6685);
    hill(70, -230, 120, 7, 0x6b4f7c);
    hill(165, -225, 110, 5, 0x6b4f7c);
    hill(-42, -190, 110, 7, 0x4d3f6c);
    hill(215, -190, 110, 6, 0x4d3f6c);

    // The lake: pearls on the spirals of a sunflower, from deep water to the crests.
    constexpr std::uint32_t palette[] = {0x14213d, 0x1f4e79, 0x2a8c9e, 0x7cc6b8, 0xf2d0a4, 0xf08a5d};
    int matte[std::size(palette)], metal[std::size(palette)];
    for (std::size_t i = 0; i < std::size(palette); ++i) {
        matte[i] = material(Lambertian{from_hex(palette[i])});
        metal[i] = material(Metal{mix(from_hex(palette[i]), Color{1, 1, 1}, Real(0.35)), Real(0.08)});
    }
    Rng random{8, 8};
    for (placing::Ball ball : placing::sunflower(16'000, {0, 0, 0, lake}, 0.2, 0.3)) {
        const double distance = std::hypot(ball.x, ball.z);
        const double height = ripple(distance);
        ball.y = height;
        const double tone = 0.42 + 0.52 * height + 0.22 * (placing::uniform(random) - 0.5);
        const auto color = static_cast<std::size_t>(
            std::clamp(tone * static_cast<double>(std::size(palette)), 0.0,
                       static_cast<double>(std::size(palette)) - 0.001));
        const auto lot = random() % 100;
        const int of = lot < 5 ? glass : lot < 35 ? metal[color] : matte[color];
        const Sphere s = placing::sphere_of(ball);
        add(s.center, ball.radius, of);
    }

    // Lanterns above the water.
    const int lantern = material(Emitter{{Real(2.6), Real(0.95), Real(0.24)}});
    constexpr double lanterns[][4] = {{-6, 1.9, 4, 0.3},    {6.5, 2.1, 4, 0.3},  {-9, 2.6, -8, 0.34},
                                      {9, 3.2, -10, 0.34},  {-2.4, 2.0, 9, 0.26}, {15, 2.4, -2, 0.3},
                                      {20, 3.6, -18, 0.4},
                                      {-5.9, 5.5, 18.2, 0.14}, {1.6, 5.4, 18.6, 0.13}, {-0.6, 5.9, 18.9, 0.1}};
    for (const auto& [x, y, z, radius] : lanterns)
        add({static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)}, radius, lantern);
    return scene;
}

}  // namespace effects
