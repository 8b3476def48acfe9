#pragma once
#include <cstddef>
#include <rt/effects.hpp>
#include <rt/effects_of.hpp>
#include <rt/scene.hpp>
#include <span>
#include <stdexcept>

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

// The number of the renderer for a scene that needs these effects (given): it has all of them, and
// no other renderer that has all of them has fewer effects. Of several such renderers, the first is
// taken.
// Throws std::invalid_argument if none has all of them.
inline std::size_t narrowest(const Effects& needed, std::span<const Effects> renderers) {
    std::size_t best = renderers.size();
    for (std::size_t i = 0; i < renderers.size(); ++i) {
        if (!covers(renderers[i], needed)) continue;
        if (best == renderers.size() || count(renderers[i]) < count(renderers[best])) best = i;
    }
    if (best == renderers.size())
        throw std::invalid_argument("no renderer has all of: " + names(needed));
    return best;
}

}  // namespace rt
