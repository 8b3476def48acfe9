#pragma once
#include <app/run.hpp>
#include <rt/scene.hpp>

namespace effects {

// Draws what --show asks for, with the renderer that has every effect.
app::Picture show_scene(const rt::SceneDescription& scene, app::Settings settings,
                        app::Progress& progress);

}  // namespace effects
