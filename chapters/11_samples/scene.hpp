#pragma once
// The scene of chapter 11: spires of balls in the evening, each with a lamp on its top.

#include <cmath>
#include <numbers>
#include <rt/effects.hpp>
#include <rt/portable.hpp>
#include <rt/rng.hpp>
#include <rt/scene.hpp>

namespace samples {

using namespace rt;

// The effects that the scene calls for.
inline constexpr Effects scene_effects{
    .mirror = true, .glass = true, .texture = true, .lens = true, .lights = true};

// The spires of the front row stand in the plane z = 0, each in the middle of its strip.
inline constexpr double strip_width = 3, distance = 17;

inline View scene_view() {
    View view;
    view.from = {0, Real(2.9), Real(distance)};
    view.at = {0, Real(2.15), 0};
    view.up = {0, 1, 0};
    view.vertical_fov = Real(2 * rt::portable::atan(9.0 / 16 * 2 * strip_width / distance));
    return view;
}

class Spires {
  public:
    SceneDescription scene;

    explicit Spires(const View& view) {
        scene.camera = {view, {Real(0.12), Real(distance)}, 0};
        scene.sky = {{Real(0.035), Real(0.014), Real(0.012)}, {0, Real(0.009), Real(0.04)}};
        for (const std::uint32_t color : colors) {
            add_material(Lambertian{from_hex(color)});
            add_material(Metal{mix(from_hex(color), {1, 1, 1}, Real(0.35)), 0});
            add_material(CheckeredMatte{from_hex(color), from_hex(0xf4ead5), Real(0.09)});
        }
        glass_ = add_material(Dielectric{Real(1.5)});
        gold_ = add_material(Metal{from_hex(0xffc46b), 0});
        lamp_ = add_material(Emitter{{7, 3, Real(0.7)}});
        const double radius = 5000;
        add(0, -radius, 0, radius,
            add_material(CheckeredMatte{from_hex(0x4a5568), from_hex(0x9a8f80), 1}));
    }

    // Adds balls on a cone, from the floor to the tip, in a spiral like that of a sunflower's
    // seeds, and a lamp above the tip.
    void add_spire(double x, double z, double height, int balls, int palette) {
        const double base = 0.27 * height;
        const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
        for (int i = 0; i < balls; ++i) {
            // Each ball has the same share of the cone's area, but balls near the tip are smaller.
            const double down = std::sqrt((i + 0.5) / balls);
            const double reach = base * down;
            const double radius = 1.02 * base * std::sqrt(1.0 / balls) * 1.7 * (0.72 + 0.28 * down);
            add(x + reach * rt::portable::cos(turn * i), radius + (1 - down) * height,
                z + reach * rt::portable::sin(turn * i), radius, ball(palette, down));
        }
        add(x, 1.06 * height + 0.3, z, 0.38, lamp_);
    }

    // A half-risen moon behind everything.
    void add_moon() {
        add(0, 12, -190, 14, add_material(Emitter{{Real(0.5), Real(0.22), Real(0.1)}}));
    }

    void add_loose(int count) {
        for (int i = 0; i < count; ++i) {
            const double x = -7 + 14 * uniform(), z = 6.5 * uniform() * uniform() + 1.4;
            const double radius = 0.06 + 0.14 * uniform() * uniform();
            const double lot = uniform();
            add(x, radius, z, radius,
                lot < 0.3   ? glass_
                : lot < 0.5 ? gold_
                            : 3 * static_cast<int>(uniform() * std::size(colors)));
        }
    }

  private:
    static constexpr std::uint32_t colors[] = {0x14213d, 0x1f4e79, 0x2a8c9e, 0x7cc6b8,
                                               0xf2d0a4, 0xf08a5d, 0xb23a48};
    int glass_ = 0, gold_ = 0, lamp_ = 0;
    Rng random_{11, 1};

    double uniform() { return static_cast<double>(random_()) * 0x1p-32; }

    int add_material(const MaterialDescription& material) {
        scene.materials.push_back(material);
        return static_cast<int>(scene.materials.size()) - 1;
    }
    void add(double x, double y, double z, double radius, int material) {
        scene.spheres.push_back(
            {{{static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)},
              static_cast<Real>(radius)},
             material,
             {}});
    }

    int ball(int palette, double down) {
        const double lot = uniform(), count = std::size(colors);
        const double tone = palette + 3.2 * (1 - down) + 1.2 * (uniform() - 0.5);
        const int color = static_cast<int>(std::fmod(tone + count, count));
        if (lot < 0.12) return glass_;
        if (lot < 0.2) return gold_;
        return 3 * color + (lot < 0.4 ? 1 : lot < 0.55 ? 2 : 0);
    }
};

inline SceneDescription make_scene(const View& view) {
    Spires spires{view};
    for (int i = 0; i < 4; ++i) spires.add_spire((i - 1.5) * strip_width, 0, 3.9, 170, 2 * i);
    for (int i = 0; i < 5; ++i) spires.add_spire((i - 2) * 1.5 * strip_width, -9, 4.6, 120, i);
    spires.add_loose(160);
    spires.add_moon();
    return std::move(spires.scene);
}

}  // namespace samples
