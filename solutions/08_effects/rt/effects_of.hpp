#pragma once
#include <rt/effects.hpp>
#include <rt/scene.hpp>

namespace rt {

// What a material calls for, wherever a sphere is made of it (given for the others).
inline void add_effects(const Lambertian&, Effects&) {}
inline void add_effects(const Dielectric&, Effects& effects) {
    effects.glass = true;
}
inline void add_effects(const CheckeredMatte&, Effects& effects) {
    effects.texture = true;
}
inline void add_effects(const PictureMatte&, Effects& effects) {
    effects.texture = true;
}
inline void add_effects(const Metal& metal, Effects& effects) {
    (metal.fuzz == 0 ? effects.mirror : effects.fuzz) = true;
}
inline void add_effects(const Emitter& emitter, Effects& effects) {
    if (emitter.radiance != Color{}) effects.lights = true;
}

// The effects without which the picture would be another one. What is in the scene but cannot be
// seen is not among them: a material that no sphere is made of, a light without light, fog without
// density, a lens without an opening, motion while the shutter is closed.
inline Effects effects_of(const SceneDescription& scene) {
    Effects effects;
    for (const SphereDescription& sphere : scene.spheres) {
        std::visit([&](const auto& material) { add_effects(material, effects); },
                   scene.materials[static_cast<std::size_t>(sphere.material)]);
        if (scene.camera.shutter > 0 && sphere.velocity != Vec3{}) effects.motion = true;
    }
    effects.lens = scene.camera.lens.aperture > 0;
    effects.fog = scene.fog && scene.fog->density > 0;
    return effects;
}

}  // namespace rt
