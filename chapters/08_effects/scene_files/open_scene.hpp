#pragma once
#include <app/run.hpp>
#include <rt/scene.hpp>

namespace effects {

// The settings of a program that draws scenes: those that a scene file need not name.
app::Settings default_settings();

// The scene that the user asked for: that of a file, or the final scene. Settings on the command
// line replace those of the scene.
rt::SceneDescription open_scene(const app::Settings& settings);

// Replaces the settings of a scene by those that the command line has.
void replace_by_given(rt::RenderSettings& of_scene, const app::Settings& settings);

}  // namespace effects
