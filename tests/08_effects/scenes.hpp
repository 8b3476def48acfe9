#pragma once
// Scenes for the tests of what chapter 08 gives.

#include <rt/effects.hpp>
#include <rt/rng.hpp>
#include <rt/scene.hpp>
#include <rt/transform.hpp>

#include "checkpoint.hpp"

namespace checkpoint {

// A small scene in which these effects, and no others, can be seen. Same effects, same scene.
inline rt::SceneDescription scene_with(const rt::Effects& effects) {
    using namespace rt;
    SceneDescription scene;
    scene.sky = {{Real(0.4), Real(0.3), Real(0.2)}, {Real(0.5), Real(0.7), 1}};
    scene.camera.view = {{0, 1, 6}, {0, Real(0.6), 0}, {0, 1, 0}, radians(40)};
    scene.images.push_back(make_image(8, 4, [](int x, int y) {
        return Color{static_cast<Real>(x) / 8, static_cast<Real>(y) / 4, Real(0.5)};
    }));
    // Materials that no sphere is made of must change nothing.
    scene.materials = {Lambertian{{Real(0.5), Real(0.6), Real(0.4)}},
                       Dielectric{Real(1.3)},
                       Metal{{1, 1, 1}, Real(0.5)},
                       Emitter{{7, 7, 7}},
                       PictureMatte{0},
                       OwnMaterial{{1, 1, 1}, 1}};
    const auto add = [&](Vec3 center, Real radius, const MaterialDescription& material,
                         Vec3 velocity = {}) {
        scene.spheres.push_back(
            {{center, radius}, static_cast<int>(scene.materials.size()), velocity});
        scene.materials.push_back(material);
    };
    const Lambertian red{{Real(0.8), Real(0.2), Real(0.1)}};
    add({0, -100, 0}, 100, red);
    add({1, Real(0.5), 2}, Real(0.5), red);
    if (effects.mirror) add({-1, 1, 0}, 1, Metal{{Real(0.9), Real(0.8), Real(0.7)}, 0});
    if (effects.fuzz) add({0, Real(0.4), 2}, Real(0.4), Metal{{1, Real(0.8), 1}, Real(0.3)});
    if (effects.glass) add({Real(1.2), 1, 0}, 1, Dielectric{Real(1.5)});
    if (effects.texture) {
        add({0, Real(1.5), -2}, Real(1.5), CheckeredMatte{{0, 0, 0}, {1, 1, 1}, Real(0.3)});
        add({-2, Real(0.6), 1}, Real(0.6), PictureMatte{0});
    }
    if (effects.own)
        add({Real(0.3), 2, Real(0.5)}, Real(0.6),
            OwnMaterial{{Real(0.2), Real(0.5), Real(0.9)}, 1});
    if (effects.lens) scene.camera.lens = {Real(0.4), 6};
    if (effects.motion) {
        scene.camera.shutter = Real(0.5);
        add({Real(-0.5), 2, 1}, Real(0.4), red, {2, 1, 0});
        add({Real(0.5), Real(1.2), 2}, Real(0.2), red, {0, -1, 0});
    }
    if (effects.lights) {
        add({2, 4, 2}, Real(0.5), Emitter{{9, 8, 5}});
        add({-2, Real(0.3), 3}, Real(0.2), Emitter{{1, 2, 4}});
    }
    if (effects.instances) {
        // Beside each other, reaching into each other and into a plain sphere.
        const auto add_map = [&](const Mat4& map) {
            add({map(0, 3), map(1, 3), map(2, 3)}, 3, red);
            scene.spheres.back().map = static_cast<int>(scene.maps.size());
            scene.maps.push_back(map);
        };
        add_map(multiply(translation({-1, Real(0.5), 2}), scaling({1, Real(0.3), Real(0.5)})));
        add_map(multiply(translation({Real(-0.5), Real(0.7), 2}),
                         multiply(rotation_z(1), scaling({1, Real(0.2), Real(0.4)}))));
    }
    if (effects.fog) scene.fog = Fog{{{0, 0, 0}, 8}, Real(0.1), {1, Real(0.9), 1}, Real(0.4)};
    if (effects.haze) scene.haze = Haze{Real(0.2), {Real(0.7), Real(0.8), Real(0.9)}};
    return scene;
}

inline constexpr unsigned sets_of_effects = 1u << rt::all_effects.size();

// The set of effects given by the bits of a number less than sets_of_effects.
inline rt::Effects numbered_effects(unsigned bits) {
    rt::Effects effects;
    for (std::size_t i = 0; i < rt::all_effects.size(); ++i)
        effects.*rt::all_effects[i].member = (bits >> i & 1) != 0;
    return effects;
}

inline bool same_color(rt::Color a, rt::Color b) {
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

}  // namespace checkpoint
