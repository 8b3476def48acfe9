#pragma once
#include <rt/effects.hpp>
#include <rt/scene.hpp>

namespace answer {

rt::Effects effects_of(const rt::SceneDescription& scene);

}  // namespace answer

namespace rt {

using answer::effects_of;

}  // namespace rt
