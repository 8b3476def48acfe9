#pragma once
#include <app/run.hpp>
#include <rt/scene.hpp>

namespace effects {

// The scene that the user asked for, from a file or the final scene, with the settings of the
// command line.
rt::SceneDescription open_scene(const app::Settings& settings);

}  // namespace effects
