#pragma once
#include <app/run.hpp>
#include <rt/scene.hpp>

namespace effects {

// The scene that the user asked for: that of a file, or the final scene. Settings on the command
// line replace those of the scene.
rt::SceneDescription open_scene(const app::Settings& settings);

}  // namespace effects
