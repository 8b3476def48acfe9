#pragma once
#include <rt/effects.hpp>
#include <rt/scene.hpp>

namespace rt {

// The effects that change the picture of this scene. Effects that cannot be seen are left out: a
// material that no sphere is made of, a light of radiance 0, fog of density 0, a lens of aperture
// 0, motion with zero shutter time.
inline Effects effects_of(const SceneDescription& scene) {
    Effects effects;
    for (const SphereDescription& sphere : scene.spheres) {
        const auto& material = scene.materials[static_cast<std::size_t>(sphere.material)];
        if (const auto* metal = std::get_if<Metal>(&material)) {
            if (metal->fuzz == 0) effects.mirror = true;
            if (metal->fuzz > 0) effects.fuzz = true;
        }
        if (std::get_if<Dielectric>(&material)) effects.glass = true;
        if (std::get_if<CheckeredMatte>(&material)) effects.texture = true;
        if (std::get_if<PictureMatte>(&material)) effects.texture = true;
        if (const auto* emitter = std::get_if<Emitter>(&material))
            if (emitter->radiance != Color{}) effects.lights = true;
        if (std::get_if<OwnMaterial>(&material)) effects.own = true;
        if (sphere.map >= 0) effects.instances = true;
        if (scene.camera.shutter > 0 && sphere.velocity != Vec3{}) effects.motion = true;
    }
    effects.lens = scene.camera.lens.aperture > 0;
    effects.fog = scene.fog && scene.fog->density > 0;
    return effects;
}

}  // namespace rt
