#pragma once
#include <rt/rng.hpp>
#include <rt/scene.hpp>
#include <rt/transform.hpp>

namespace effects {

// The scene in which effects are measured: 200 small matte spheres on a large one, with these
// effects.
inline rt::SceneDescription study_scene(const rt::Effects& effects) {
    using namespace rt;
    SceneDescription scene;
    scene.sky = {{1, 1, 1}, {Real(0.5), Real(0.7), 1}};
    scene.camera.view = {{0, 3, 9}, {0, Real(0.3), 0}, {0, 1, 0}, radians(35)};
    auto& materials = scene.materials;
    materials = {Lambertian{{Real(0.6), Real(0.5), Real(0.4)}},
                 Lambertian{{Real(0.2), Real(0.5), Real(0.8)}}};
    if (effects.mirror) materials.push_back(Metal{{1, Real(0.8), 1}, 0});
    if (effects.fuzz) materials.push_back(Metal{{1, 1, 1}, Real(0.3)});
    if (effects.glass) materials.push_back(Dielectric{});
    if (effects.texture) materials.push_back(CheckeredMatte{{0, 0, 0}, {1, 1, 1}, Real(0.1)});
    if (effects.own) materials.push_back(OwnMaterial{{Real(0.2), Real(0.5), Real(0.9)}, 1});
    if (effects.lights) materials.push_back(Emitter{{2, 2, 2}});
    if (effects.lens) scene.camera.lens = {Real(0.2), 9};
    if (effects.motion) scene.camera.shutter = 1;
    if (effects.fog) scene.fog = Fog{{{0, 0, 0}, 20}, Real(0.02)};
    if (effects.haze) scene.haze = Haze{Real(0.05), {Real(0.75), Real(0.85), 1}};
    scene.spheres.push_back({{{0, -1000, 0}, 1000}, 0});
    Rng random{1, 8};
    for (int i = 0; i < 200; ++i) {
        const Real radius = Real(0.1) + Real(0.3) * random.uniform();
        const Vec3 center{random.uniform(-6, 6), radius, random.uniform(-8, 5)};
        const auto kinds = static_cast<int>(materials.size()) - 1;
        SphereDescription sphere{{center, radius}, 1 + i % kinds};
        // As few lights, moving spheres and instances as a scene may have.
        if (effects.lights && sphere.material == kinds && i > 20) sphere.material = 1;
        if (effects.motion && i < 20) sphere.velocity = {0, radius, 0};
        if (effects.instances && i < 20) {
            sphere.map = static_cast<int>(scene.maps.size());
            scene.maps.push_back(
                multiply(translation(center), scaling({radius, radius / 2, radius})));
        }
        scene.spheres.push_back(sphere);
    }
    return scene;
}

}  // namespace effects
