#pragma once
#include <app/run.hpp>
#include <rt/scene.hpp>

namespace effects {

// Draws what --show asks for, with the renderer that has every effect.
app::Picture show_scene(const rt::SceneDescription& scene, const app::Settings& settings,
                        app::Progress& progress);

// The settings of a program, with those of a scene in place of its own.
app::Settings with_settings_of(const rt::SceneDescription& scene, app::Settings settings);

}  // namespace effects
