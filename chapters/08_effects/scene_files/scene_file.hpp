#pragma once
// Scene files: docs/scene-files.md says what they may contain.

#include <app/limits.hpp>
#include <app/value.hpp>
#include <filesystem>
#include <functional>
#include <rt/scene.hpp>
#include <string>

namespace effects {

// The most that a file may ask for, so that a slip does not fill the memory.
struct Limits {
    int spheres = 1'000'000;
    int image_pixels = 1 << 23;              // of all images of a scene together
    std::int64_t pixels = app::most_pixels;  // of the picture
};

// The index in the scene of the material that a value names. Fails if it is a light, which only a
// plain sphere can be.
using MaterialOf = std::function<int(const app::Value& name)>;

// How a later chapter reads shapes of its own: a list, after the spheres.
struct OtherShapes {
    std::string key;  // of the list
    std::function<void(const app::Value& shape, const MaterialOf& material_of)> read_one;
};

// The scene that a file describes. Throws app::UsageError if the file cannot be read or does not
// follow the format. Its message is one line: the file, the position in it and what is allowed.
rt::SceneDescription read_scene(const std::filesystem::path& file, const OtherShapes& others = {});

// The scene that a text describes. `name` stands for the file in messages; image files are looked
// for in `folder`.
rt::SceneDescription parse_scene(const std::string& text, const std::string& name,
                                 const std::filesystem::path& folder, const Limits& limits = {},
                                 const OtherShapes& others = {});

}  // namespace effects
