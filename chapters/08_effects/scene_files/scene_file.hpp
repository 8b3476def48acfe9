#pragma once
// Scene files: docs/scene-files.md says what they may contain.

#include <app/limits.hpp>
#include <app/value.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <rt/scene.hpp>
#include <string>

namespace effects {

// The most that a file may ask for, so that a slip does not fill the memory.
struct Limits {
    int spheres = 1'000'000;
    int image_pixels = 1 << 23;              // of all images of a scene together
    std::int64_t pixels = app::most_pixels;  // of the picture
};

// The materials of a scene that is being read, for shapes of later chapters. A material is known by
// its index in the scene. What is wrong is blamed on a value of the file.
class SceneMaterials {
  public:
    virtual ~SceneMaterials() = default;
    // The material that a value names.
    virtual int named(const app::Value& name) = 0;
    // The scene file's material of this name; none if it has none.
    virtual std::optional<int> find(const std::string& name) = 0;
    virtual int add(const rt::MaterialDescription& material) = 0;
    // Reads an image and returns its index in the scene.
    virtual int add_image(const app::Value& where, const std::string& file) = 0;
    virtual bool shows_image(int material) const = 0;
};

// How a later chapter reads shapes of its own: a list, after the spheres.
struct OtherShapes {
    std::string key;  // of the list
    std::function<void(const app::Value& shape, SceneMaterials& materials)> read_one;
};

// The scene that a file describes. Throws app::UsageError if the file cannot be read or does not
// follow the format. Its message is one line: the file, the position in it and what is allowed.
rt::SceneDescription read_scene(const std::filesystem::path& file, const OtherShapes& others = {});

// Reads a file that a scene needs, such as an image: `kind` is "an image". What is wrong is blamed
// on the value `where`.
using ReadNeighbor = std::function<std::string(const app::Value& where, const std::string& name,
                                               const std::string& kind, std::size_t most_bytes)>;

// The scene that a text describes. `name` stands for the file in messages.
rt::SceneDescription parse_scene(const std::string& text, const std::string& name,
                                 const ReadNeighbor& read, const Limits& limits = {},
                                 const OtherShapes& others = {});

// The same; the files that it names are looked for in `folder`.
rt::SceneDescription parse_scene(const std::string& text, const std::string& name,
                                 const std::filesystem::path& folder, const Limits& limits = {},
                                 const OtherShapes& others = {});

}  // namespace effects
