#pragma once
// Scenes that may have meshes.

#include <app/run.hpp>
#include <filesystem>
#include <functional>
#include <rt/mesh_scene.hpp>
#include <string>

#include "scene_file.hpp"

namespace full_renderer {

// Says what is being done, such as "reading pot.obj: 40 %".
using Say = std::function<void(const std::string& what)>;

// The scene that a file describes, as effects::read_scene reads it, and its meshes.
rt::MeshedDescription read_scene(const std::filesystem::path& file, const Say& say = {});

// The same of a text, which `name` stands for in messages.
rt::MeshedDescription parse_scene(const std::string& text, const std::string& name,
                                  const effects::ReadNeighbor& read, const Say& say = {});

// The scene that the user asked for: that of a file, or the final scene. Settings on the command
// line replace those of the scene.
rt::MeshedDescription open_scene(const app::Settings& settings, const Say& say = {});

}  // namespace full_renderer
