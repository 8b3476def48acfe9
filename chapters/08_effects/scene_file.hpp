#pragma once
// Scene files: docs/scene-files.md says what they may contain.

#include <app/limits.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <rt/scene.hpp>
#include <string>

namespace effects {

// The most that a file may ask for, so that a slip does not fill the memory.
struct Limits {
    int spheres = 1'000'000;
    std::size_t triangles = 4'000'000;       // of all meshes of a scene together
    int image_pixels = 1 << 23;              // of all images of a scene together
    std::int64_t pixels = app::most_pixels;  // of the picture
};

// Reads a mesh from the bytes of a file, with smooth normals (true), without them (false), or as
// the file has them (none).
// Throws std::invalid_argument, which says what is wrong with the file. A program without a
// MeshReader draws no meshes.
using MeshReader = std::function<rt::Mesh(const std::string& bytes, std::optional<bool> smooth)>;

// The scene that a file describes. Throws app::UsageError if the file cannot be read or does not
// follow the format. Its message is one line: the file, the position in it and what is allowed.
rt::SceneDescription read_scene(const std::filesystem::path& file,
                                const MeshReader& read_mesh = {});

// The scene that a text describes. `name` stands for the file in messages; image files
// and meshes are looked for in `folder`.
rt::SceneDescription parse_scene(const std::string& text, const std::string& name,
                                 const std::filesystem::path& folder, const Limits& limits = {},
                                 const MeshReader& read_mesh = {});

}  // namespace effects
