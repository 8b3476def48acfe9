#pragma once
#include <rt/effects.hpp>
#include <rt/scene.hpp>

namespace rt {

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
        if (std::get_if<Emitter>(&material)) effects.lights = true;
        if (std::get_if<OwnMaterial>(&material)) effects.own = true;
        if (sphere.map >= 0) effects.instances = true;
        if (sphere.velocity != Vec3{}) effects.motion = true;
    }
    effects.lens = scene.camera.lens.aperture > 0;
    effects.fog = scene.fog.has_value();
    return effects;
}

}  // namespace rt
