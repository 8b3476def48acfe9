#pragma once
// Scenes that may have meshes.

#include <app/run.hpp>
#include <filesystem>
#include <rt/mesh_scene.hpp>

namespace full_renderer {

// The scene that a file describes, as effects::read_scene reads it, and its meshes.
rt::MeshedDescription read_scene(const std::filesystem::path& file);

// The scene that the user asked for: that of a file, or the final scene. Settings on the command
// line replace those of the scene.
rt::MeshedDescription open_scene(const app::Settings& settings);

}  // namespace full_renderer
