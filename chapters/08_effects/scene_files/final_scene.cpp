#include "final_scene.hpp"

#include <algorithm>
#include <array>
#include <rt/facing.hpp>
#include <rt/portable.hpp>
#include <rt/rng.hpp>
#include <rt/transform.hpp>

#include "placing.hpp"

namespace effects {
namespace {

using namespace rt;
using placing::Ball;

constexpr double lake_radius = 40;
constexpr int pearls = 16'000;
constexpr Ball sun{150, 4, -300, 21};

// How high the lake stands at this distance from where the drop fell.
double ripple(double distance) {
    constexpr double wave_length = 6.6, reach = 15;
    return 1.5 * rt::portable::cos(2 * std::numbers::pi * distance / wave_length) *
           rt::portable::exp(-distance / reach) * std::min(1.0, distance / 2.5);
}

// A normal of the water there.
Vec3 normal_at(double x, double z) {
    constexpr double step = 0.01;
    const double distance = rt::portable::hypot(x, z);
    const double slope = (ripple(distance + step) - ripple(distance - step)) / (2 * step);
    return {static_cast<Real>(-slope * x / distance), 1, static_cast<Real>(-slope * z / distance)};
}

struct Angles {
    double x, y, z;
};

class Composition {
  public:
    SceneDescription scene;

    int material(const MaterialDescription& description) {
        scene.materials.push_back(description);
        return static_cast<int>(scene.materials.size() - 1);
    }
    void add(const Ball& ball, int of) {
        scene.spheres.push_back({placing::sphere_of(ball), of, {}});
    }
    // Adds a ball that is stretched, then turned around z, y and x, by angles in radians.
    void add_stretched(const Ball& ball, Vec3 scale, Angles by, int of) {
        add(ball, of);
        SphereDescription& sphere = scene.spheres.back();
        const auto angle = [](double radians) { return static_cast<Real>(radians); };
        const Mat4 turned = multiply(rotation_x(angle(by.x)),
                                     multiply(rotation_y(angle(by.y)), rotation_z(angle(by.z))));
        sphere.map = static_cast<int>(scene.maps.size());
        scene.maps.push_back(multiply(translation(sphere.shape.center),
                                      multiply(turned, scaling(sphere.shape.radius * scale))));
        sphere.shape.radius *= max_component(scale);
    }
};

// Hills, one behind the other, the farther ones paler, and the sun that sets between them. A hill
// is the top of a large sphere.
void add_horizon(Composition& picture) {
    struct Hill {
        double x, z, top, radius;
        std::uint32_t color;
    };
    constexpr Hill hills[] = {{0, -320, 21, 170, 0x8d6685},  {262, -310, 19, 150, 0x8d6685},
                              {70, -230, 7, 120, 0x6b4f7c},  {165, -225, 5, 110, 0x6b4f7c},
                              {-42, -190, 7, 110, 0x4d3f6c}, {215, -190, 6, 110, 0x4d3f6c}};
    for (const Hill& hill : hills)
        picture.add({hill.x, hill.top - hill.radius, hill.z, hill.radius},
                    picture.material(Lambertian{from_hex(hill.color)}));
    picture.add(sun, picture.material(Emitter{{6, Real(0.45), Real(0.08)}}));
}

// A drop of glass, a little longer than it is wide. Around it are the droplets that it has splashed
// up, each stretched along its way up and outward.
void add_drop(Composition& picture, int glass) {
    picture.add_stretched({0, 2.9, 0, 2.3}, {1, Real(1.06), 1}, {0, 0, 0}, glass);
    for (int i = 0; i < 18; ++i) {
        const double angle = 2.39996 * i, distance = 3.1 + 0.9 * rt::portable::sin(1.7 * i);
        const double size = 0.185 + 0.065 * rt::portable::cos(4.1 * i);
        picture.add_stretched(
            {distance * rt::portable::cos(angle), 3.1 + 1.1 * rt::portable::sin(2.9 * i),
             distance * rt::portable::sin(angle), size},
            {Real(0.9), Real(1.4), Real(0.9)}, {0, -angle, -0.5}, glass);
    }
}

// The lake: pearls on the spirals of a sunflower, lifted by the ripples and colored by their
// height, from deep water to the crests; on the side of a wave that faces the sun, as if higher.
void add_lake(Composition& picture, int glass) {
    // Still water below the pearls, and as far as the hills.
    picture.add({0, -2001, 0, 2000},
                picture.material(Metal{{Real(0.24), Real(0.24), Real(0.34)}, Real(0.10)}));

    constexpr std::array<std::uint32_t, 6> colors{0x14213d, 0x1f4e79, 0x2a8c9e,
                                                  0x7cc6b8, 0xf2d0a4, 0xf08a5d};
    std::array<int, colors.size()> matte{}, metal{};
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const Color color = from_hex(colors[i]);
        matte[i] = picture.material(Lambertian{color});
        metal[i] = picture.material(Metal{mix(color, {1, 1, 1}, Real(0.35)), Real(0.08)});
    }
    Rng random{8, 8};
    for (Ball pearl : placing::sunflower(pearls, {0, 0, 0, lake_radius}, 0.2, 0.3)) {
        pearl.y = ripple(rt::portable::hypot(pearl.x, pearl.z));
        const int sunny = facing(normal_at(pearl.x, pearl.z), placing::sphere_of(sun).center);
        const double tone = 0.31 + 0.52 * pearl.y + 0.07 * sunny + 0.22 * placing::uniform(random);
        const auto color = static_cast<std::size_t>(std::clamp(tone, 0.0, 0.999) * colors.size());
        const auto lot = random() % 100;
        picture.add(pearl, lot < 5 ? glass : lot < 35 ? metal[color] : matte[color]);
    }
}

// Lanterns, few and not too small, so that paths find each of them often enough.
void add_lanterns(Composition& picture) {
    const int flame = picture.material(Emitter{{Real(2.8), Real(0.50), Real(0.09)}});
    constexpr Ball lanterns[] = {{-6, 1.9, 4, 0.3},   {6.8, 2.1, 5, 0.3},   {-9, 2.8, -8, 0.34},
                                 {9, 3.2, -10, 0.34}, {-2.4, 2.0, 9, 0.26}, {15, 2.4, -2, 0.3},
                                 {20, 3.6, -18, 0.4}};
    for (const Ball& lantern : lanterns) picture.add(lantern, flame);
}

}  // namespace

SceneDescription final_scene() {
    Composition picture;
    SceneDescription& scene = picture.scene;
    scene.camera.view.from = {-4, Real(7.8), 25};
    scene.camera.view.at = {4, Real(3.85), 0};
    scene.camera.view.vertical_fov = radians(29);
    scene.camera.lens = {Real(0.22), 25};
    scene.sky = {{Real(1.5), Real(0.50), Real(0.26)}, {Real(0.04), Real(0.11), Real(0.4)}};

    const int glass = picture.material(Dielectric{Real(1.5)});
    add_horizon(picture);
    add_drop(picture, glass);
    add_lake(picture, glass);
    add_lanterns(picture);
    return scene;
}

}  // namespace effects
