#pragma once
// The scenes of docs/accuracy.md: matte, metal and glass under a sky; lamps in the dark, and the
// same lamps in fog; hollow and solid glass balls; and a hundred thousand beads.

#include <rt/cover_scene.hpp>
#include <rt/scene.hpp>

#include "../../10_batches/scene.hpp"
#include "../scene.hpp"

namespace accuracy {

using namespace rt;

constexpr Effects cover_effects{.mirror = true, .fuzz = true, .glass = true, .lens = true};
constexpr Effects lamp_effects = samples::scene_effects;
constexpr Effects glass_effects{.glass = true, .texture = true};
constexpr Effects bead_effects = batches::scene_effects;
constexpr Effects fog_effects = [] {
    Effects all = lamp_effects;
    all.fog = true;
    return all;
}();

inline SceneDescription lamp_scene() {
    return samples::make_scene(samples::scene_view());
}
inline SceneDescription fog_scene() {
    SceneDescription scene = lamp_scene();
    scene.fog = Fog{{{0, 0, 0}, 30}, Real(0.03), {1, 1, 1}, Real(0.5)};
    return scene;
}
// The cover scene, with the lens that the classic tutorial gives it.
inline SceneDescription cover_scene() {
    SceneDescription scene = study::cover_scene(study::make_cover());
    scene.camera.lens = {Real(0.1), 10};
    return scene;
}
inline SceneDescription bead_scene() {
    return batches::make_scene(100'000, batches::scene_view());
}

// Rows of glass balls on a checkered floor, every other ball hollow. The balls on one diagonal are
// red and matte instead.
inline SceneDescription glass_scene() {
    SceneDescription scene;
    scene.camera.view = {{Real(2.5), Real(2.4), 8}, {0, Real(0.2), 0}, {0, 1, 0}, radians(36)};
    scene.sky = {{Real(0.9), Real(0.8), Real(0.7)}, {Real(0.2), Real(0.4), Real(0.8)}};
    scene.materials = {Dielectric{Real(1.5)}, Dielectric{1 / Real(1.5)},
                       CheckeredMatte{from_hex(0x1f4e79), from_hex(0xf2d0a4), 1},
                       Lambertian{from_hex(0xb23a48)}};
    scene.spheres.push_back({{{0, Real(-1000.5), 0}, 1000}, 2, {}});
    for (int row = -3; row <= 3; ++row)
        for (int column = -3; column <= 3; ++column) {
            const Vec3 center{static_cast<Real>(column), 0, static_cast<Real>(row)};
            const bool is_hollow = (row + column) % 2 != 0, is_red = row == column;
            scene.spheres.push_back({{center, Real(0.48)}, is_red ? 3 : 0, {}});
            if (is_hollow) scene.spheres.push_back({{center, Real(0.4)}, 1, {}});
        }
    return scene;
}

}  // namespace accuracy
