#pragma once
// The scene of chapter 10: matte, metal and glass beads on the shell of an ammonite, and beads that
// have come loose and roll out of its mouth.

#include <cmath>
#include <numbers>
#include <rt/effects.hpp>
#include <rt/portable.hpp>
#include <rt/rng.hpp>
#include <rt/scene.hpp>

namespace batches {

using namespace rt;

// The effects that the scene calls for.
inline constexpr Effects scene_effects{.fuzz = true, .glass = true, .lens = true};

// The vector with these coordinates relative to the floor. The floor is tilted, by an angle of the
// triangle with the sides 3, 4 and 5, so that the sky, which is brightest straight above, lights it
// from the side.
inline Vec3 on_floor(double right, double up, double toward_us) {
    return {static_cast<Real>(0.8 * right + 0.6 * up), static_cast<Real>(0.8 * up - 0.6 * right),
            static_cast<Real>(toward_us)};
}

inline View scene_view() {
    View view;
    view.from = on_floor(-1.6, 4.7, 7.2);
    view.at = on_floor(-0.45, -0.35, 0.3);
    view.up = on_floor(0, 1, 0);
    view.vertical_fov = radians(37);
    return view;
}

// A tube that is wound up in a spiral. With each turn, spiral and tube grow by the same factor.
struct Shell {
    static constexpr double turns = 4.85, growth = 1.9, rim = 3.3, width = 0.31, start = 0.52;

    // The distance from the middle of the shell to the middle of the tube, `inward` turns away from
    // the mouth.
    static double distance(double inward) { return rim * rt::portable::pow(growth, -inward); }
    static double angle(double inward) { return 2 * std::numbers::pi * (start - inward); }
};

class Beads {
  public:
    SceneDescription scene;

    explicit Beads(const View& view) {
        scene.camera = {view, {Real(0.09), Real(7.6)}, 0};
        scene.sky = {{Real(0.015), Real(0.04), Real(0.13)}, {Real(2.9), Real(2.2), Real(1.6)}};
        for (const std::uint32_t color : colors) {
            scene.materials.push_back(Lambertian{from_hex(color)});
            scene.materials.push_back(
                Metal{mix(from_hex(color), {1, 1, 1}, Real(0.35)), Real(0.12)});
        }
        scene.materials.push_back(Dielectric{Real(1.5)});
        scene.materials.push_back(Metal{from_hex(0xffc46b), Real(0.1)});
        scene.materials.push_back(Metal{{Real(0.035), Real(0.06), Real(0.12)}, Real(0.12)});
        const double radius = 2000;
        add(0, floor - radius, 0, radius, gold + 1);
        // The innermost part of the shell: a ball of gold.
        add(0, 0, 0, 0.72 * Shell::distance(Shell::turns), gold);
    }

    // Adds the whole shell: rings of beads, each ring turned by half a bead against the ring before
    // it.
    void add_shell(int count) {
        const int ring = std::max(3, static_cast<int>(72 * std::sqrt(count / 100'000.0)));
        for (int i = 0; i < count; ++i) {
            const double inward = Shell::turns * (i / ring) * ring / count;
            const double around = 2 * std::numbers::pi * (i % ring + 0.5 * (i / ring % 2)) / ring;
            const double distance = Shell::distance(inward), tube = distance * Shell::width;
            const double reach = distance + tube * rt::portable::cos(around),
                         angle = Shell::angle(inward);
            add(reach * rt::portable::cos(angle), tube * rt::portable::sin(around),
                -reach * rt::portable::sin(angle), 0.97 * std::numbers::pi / ring * tube,
                bead(inward, around));
        }
    }

    void add_loose(int count) {
        for (int i = 0; i < count; ++i) {
            const double out = uniform() * uniform(), side = uniform() + uniform() - 1;
            const double distance = Shell::distance(-0.32 * out) * (1 + 0.42 * side * (0.6 + out));
            const double angle = Shell::angle(-0.32 * out - 0.015);
            const double radius = 0.022 + 0.03 * uniform() * uniform();
            const int color = static_cast<int>(uniform() * std::size(colors));
            const double lot = uniform();
            add(distance * rt::portable::cos(angle), floor + radius,
                -distance * rt::portable::sin(angle), radius,
                lot < 0.3   ? glass
                : lot < 0.4 ? gold
                : lot < 0.7 ? 2 * color
                            : 2 * color + 1);
        }
    }

  private:
    static constexpr std::uint32_t colors[] = {0x14213d, 0x1f4e79, 0x2a8c9e,
                                               0x7cc6b8, 0xf2d0a4, 0xf08a5d};
    static constexpr int glass = 2 * static_cast<int>(std::size(colors)), gold = glass + 1;
    static constexpr double floor = -1.02 * Shell::rim * Shell::width;  // just below the shell
    Rng random_{10, 1};

    double uniform() { return static_cast<double>(random_()) * 0x1p-32; }

    void add(double right, double up, double toward_us, double radius, int material) {
        scene.spheres.push_back(
            {{on_floor(right, up, toward_us), static_cast<Real>(radius)}, material, {}});
    }

    // The material of a bead: gold on the ribs; between the ribs, glass, or matte or metal in a
    // color that depends mostly on how far outward the bead is.
    int bead(double inward, double around) {
        const double ribs = 26 * inward + 0.35 * rt::portable::cos(around);
        const double lot = uniform();
        if (ribs - std::trunc(ribs) < 0.13) return gold;
        const double outward = 0.5 + 0.5 * rt::portable::cos(around);
        const double tone =
            0.08 + 0.9 * outward * outward + 0.2 * (uniform() - 0.5) - 0.06 * inward;
        const int color = static_cast<int>(std::size(colors) * std::clamp(tone, 0.0, 0.999));
        return lot < 0.07 ? glass : lot < 0.4 ? 2 * color + 1 : 2 * color;
    }
};

// A scene of `count` spheres, which include the floor and the ball in the middle. The fewer beads
// the shell has, the larger they are.
inline SceneDescription make_scene(int count, const View& view) {
    Beads beads{view};
    const int loose = count / 50;
    beads.add_loose(loose);
    beads.add_shell(count - loose - 2);
    return std::move(beads.scene);
}

}  // namespace batches
