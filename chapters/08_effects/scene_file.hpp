#pragma once
// Scene files: docs/scene-files.md says what they may contain.

#include <app/limits.hpp>
#include <filesystem>
#include <rt/scene.hpp>
#include <string>

namespace effects {

// The most that a file may ask for, so that a slip does not fill the memory.
struct Limits {
    int spheres = 1'000'000;
    int image_pixels = 1 << 23;              // of all images of a scene together
    std::int64_t pixels = app::most_pixels;  // of the picture
};

// The scene that a file describes. Throws app::UsageError if the file cannot be read or does not
// follow the format: one line with the file, the position in it and what is allowed.
rt::SceneDescription read_scene(const std::filesystem::path& file);

// The scene that a text describes. `name` stands for the file in messages; image files
// are looked for in `folder`.
rt::SceneDescription parse_scene(const std::string& text, const std::string& name,
                                 const std::filesystem::path& folder, const Limits& limits = {});

}  // namespace effects
