#pragma once
// The scene of chapter 10: beads of matte, metal and glass on the shell of an ammonite.

#include <cmath>
#include <rt/effects.hpp>
#include <rt/rng.hpp>
#include <rt/scene.hpp>

namespace batches {

using namespace rt;

// What the scene calls for.
inline constexpr Effects scene_effects{.fuzz = true, .glass = true, .lens = true};

inline View scene_view() {
    View view;
    view.from = {Real(-1.5), Real(5.2), Real(7)};
    view.at = {Real(0.1), Real(0), Real(0.2)};
    view.vertical_fov = radians(38);
    return view;
}

inline SceneDescription make_scene(int count, const View& view) {
    constexpr std::uint32_t palette[] = {0x1f4e79, 0x2a8c9e, 0x7cc6b8,
                                         0xf2d0a4, 0xf08a5d, 0xb83b5e};
    constexpr int colors = std::size(palette);
    SceneDescription scene;
    scene.camera = {view, {Real(0.05), 8}, 0};
    scene.sky = {{Real(0.03), Real(0.05), Real(0.12)}, {Real(1.5), Real(1.3), Real(1.1)}};
    for (const std::uint32_t color : palette) {
        scene.materials.push_back(Lambertian{from_hex(color)});
        scene.materials.push_back(Metal{mix(from_hex(color), {1, 1, 1}, Real(0.4)), Real(0.1)});
    }
    const int glass = static_cast<int>(scene.materials.size());
    scene.materials.push_back(Dielectric{Real(1.5)});
    scene.materials.push_back(Metal{{Real(0.2), Real(0.22), Real(0.3)}, Real(0.15)});
    scene.spheres.push_back({{{0, -1001, 0}, 1000}, glass + 1, {}});
    Rng random{10, 1};
    for (int i = 1; i < count; ++i) {
        const double share = static_cast<double>(i) / count;
        const double turn = 2 * std::numbers::pi * 5 * share;
        const double distance = 3.4 * std::pow(1.9, 5 * (share - 1));
        const double tube = 0.31 * distance, around = i * 2.39996322972865332;
        const double reach = distance + tube * std::cos(around);
        const Vec3 center{static_cast<Real>(reach * std::cos(turn)),
                          static_cast<Real>(tube * std::sin(around)),
                          static_cast<Real>(reach * std::sin(turn))};
        const int color = static_cast<int>(share * colors);
        const auto lot = random() % 100;
        scene.spheres.push_back({{center, static_cast<Real>(0.04 * tube)},
                                 lot < 15   ? glass
                                 : lot < 45 ? 2 * color + 1
                                            : 2 * color,
                                 {}});
    }
    return scene;
}

}  // namespace batches
