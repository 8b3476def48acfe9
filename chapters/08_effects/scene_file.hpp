#pragma once
// Scene files: docs/scene-files.md says what may stand in them.

#include <app/limits.hpp>
#include <filesystem>
#include <rt/scene.hpp>
#include <string>

namespace effects {

// What a file may ask for at most, so that a slip does not fill the memory.
struct Limits {
    int spheres = 1'000'000;
    int image_pixels = 1 << 23;              // of all images of a scene together
    std::int64_t pixels = app::most_pixels;  // of the picture
};

// The scene that a file describes. Throws app::UsageError, one line with the file, the place in it
// and what is allowed, for a file that cannot be read or does not hold to the format.
rt::SceneDescription read_scene(const std::filesystem::path& file);

// The scene of a text. `name` stands for it in messages; image files are looked for in `folder`.
rt::SceneDescription parse_scene(const std::string& text, const std::string& name,
                                 const std::filesystem::path& folder, const Limits& limits = {});

}  // namespace effects
