#pragma once
#include <rt/effects_of.hpp>

namespace rt {

// The effects that a renderer of this scene needs (given): those of 08.1, and those that later
// chapters have added.
inline Effects needed_effects(const SceneDescription& scene) {
    const Effects needed = with(effects_of(scene), added_effects(scene));
    if (scene.meshes.empty()) return needed;
    // A mesh calls for the same effects as a sphere of its material.
    SceneDescription of_meshes;
    of_meshes.materials = scene.materials;
    for (const MeshDescription& mesh : scene.meshes)
        of_meshes.spheres.push_back({{}, mesh.material});
    return with(needed, effects_of(of_meshes));
}

}  // namespace rt
