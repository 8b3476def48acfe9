#pragma once
#include <rt/effects_of.hpp>

namespace rt {

// The effects that a renderer of this scene needs (given): those of 08.1, and those that later
// chapters have added.
template <class Scene>
Effects needed_effects(const Scene& scene) {
    const Effects needed = with(effects_of(scene), added_effects(scene));
    // Any other shape calls for the same effects as a sphere of its material.
    SceneDescription as_spheres;
    for_other_shapes(scene, [&](int material) { as_spheres.spheres.push_back({{}, material}); });
    if (as_spheres.spheres.empty()) return needed;
    as_spheres.materials = scene.materials;
    return with(needed, with(effects_of(as_spheres), added_effects(as_spheres)));
}

}  // namespace rt
