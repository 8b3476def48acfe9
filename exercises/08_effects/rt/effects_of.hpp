#pragma once
#include <rt/effects.hpp>
#include <rt/scene.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 08.1. The effects that change the picture of this scene. Metal is a mirror if its fuzz
// is 0. A material is a variant: std::get_if<Metal>(&material) points to the Metal that it holds,
// and is null if it holds another type. OwnMaterial, yours from 05.6, calls for the effect `own`. A
// sphere of any material may move. A sphere whose map is 0 or more is an instance.
// Star: leave out every effect that cannot be seen: a material that no sphere is made of, a light
// whose radiance is 0, fog of density 0, a lens of aperture 0, a moving sphere with zero shutter
// time. A scene without spheres may have fog and a lens.
inline Effects effects_of(const SceneDescription& scene) {
    return rt::todo("08.1", scene);
}

}  // namespace rt
