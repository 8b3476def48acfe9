#pragma once
#include <rt/effects.hpp>
#include <rt/scene.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 08.1. The effects that change the picture of this scene. The effects of materials are
// given, except for `own`, the effect of OwnMaterial, your material from 05.6. A sphere of any
// material other than a light may move. A sphere whose map is 0 or more is an instance.
// Star: leave out every effect that cannot be seen: a material that no sphere is made of, a light
// whose radiance is 0, fog of density 0, a lens of aperture 0, a moving sphere with zero shutter
// time. A scene without spheres may have fog and a lens.
inline Effects effects_of(const SceneDescription& scene) {
    rt::todo("08.1", scene);  // delete this line when you have filled the gaps
    Effects effects;          // all of them false
    for (const SphereDescription& sphere : scene.spheres) {
        // A variant holds a value of one of several types. get_if points to it if it is a Metal,
        // and is null if it is not.
        const auto& material = scene.materials[static_cast<std::size_t>(sphere.material)];
        if (const auto* metal = std::get_if<Metal>(&material)) {
            if (metal->fuzz == 0) effects.mirror = true;
            if (metal->fuzz > 0) effects.fuzz = true;
        }
        if (std::get_if<Dielectric>(&material)) effects.glass = true;
        if (std::get_if<CheckeredMatte>(&material)) effects.texture = true;
        if (std::get_if<PictureMatte>(&material)) effects.texture = true;
        if (std::get_if<Emitter>(&material)) effects.lights = true;
        // Gap 1: own, instances, motion.
    }
    // Gap 2: lens, fog.
    return effects;
}

}  // namespace rt
