#pragma once
#include <rt/effects_of.hpp>

namespace rt {

// The effects that a renderer of this scene needs (given): those of 08.1, and those of what later
// chapters have added to scenes.
inline Effects needed_effects(const SceneDescription& scene) {
    return with(effects_of(scene), added_effects(scene));
}

}  // namespace rt
