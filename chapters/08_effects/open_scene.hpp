#pragma once
#include <app/run.hpp>
#include <rt/scene.hpp>

namespace effects {

// The scene that the person asked for, a file's or the final scene, with the settings from the
// command line.
rt::SceneDescription open_scene(const app::Settings& settings);

}  // namespace effects
