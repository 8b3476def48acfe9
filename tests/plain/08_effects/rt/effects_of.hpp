#pragma once
#include <rt/effects.hpp>
#include <rt/scene.hpp>

namespace rt {

inline Effects effects_of(const SceneDescription& scene) {
    Effects effects;
    for (const SphereDescription& sphere : scene.spheres) {
        const auto& material = scene.materials[static_cast<std::size_t>(sphere.material)];
        if (const auto* const metal = std::get_if<Metal>(&material))
            (metal->fuzz == 0 ? effects.mirror : effects.fuzz) = true;
        if (std::holds_alternative<Dielectric>(material)) effects.glass = true;
        if (std::holds_alternative<CheckeredMatte>(material) ||
            std::holds_alternative<PictureMatte>(material))
            effects.texture = true;
        if (std::holds_alternative<OwnMaterial>(material)) effects.own = true;
        if (std::holds_alternative<Emitter>(material)) effects.lights = true;
        if (sphere.map >= 0) effects.instances = true;
        if (sphere.velocity != Vec3{}) effects.motion = true;
    }
    effects.lens = scene.camera.lens.aperture > 0;
    effects.fog = scene.fog.has_value();
    return effects;
}

}  // namespace rt
