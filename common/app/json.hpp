#pragma once
// Strict reading of JSON files that people write: every error says where it is and what is allowed.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace app {

// A value of a JSON text.
struct Json {
    enum class Kind { null, boolean, number, text, list, object };

    Kind kind = Kind::null;
    double number = 0;                   // for a boolean, 0 or 1
    std::string text = {};               // for a text
    std::vector<Json> items = {};        // for a list; for an object, the members' values
    std::vector<std::string> keys = {};  // for an object: as many as items, all different
};

inline constexpr std::size_t max_json_bytes = 4 << 20;
inline constexpr int max_json_depth = 16;

// The contents of a regular file of at most `most` bytes. Throws UsageError, with `name` in front,
// if the file is missing, a folder, a device, too large, or cannot be read.
std::string read_input_file(const std::filesystem::path& path, const std::string& name,
                            std::size_t most);

// The value that a text holds. Throws UsageError that begins with `name`, line and column if
// the text is not JSON (RFC 8259, so neither comments nor NaN), if a number does not fit a
// double, or if the text is nested deeper than max_json_depth; with `name` and the path if
// an object has a key twice.
Json parse_json(const std::string& text, const std::string& name);

// A member of an object; null if there is none with this key and kind.
const Json* find(const Json& object, const std::string& key, Json::Kind kind);

// The value as a JSON text on one line. A number that is not finite becomes null.
std::string to_text(const Json& json);

// Where a value stands in a file, as people write it: spheres[3].material, materials["a b"].
std::string path_of_member(const std::string& parent, const std::string& key);
std::string path_of_item(const std::string& parent, std::size_t index);

// What a person wrote, in quotes, cut to a length that helps.
std::string quoted(const std::string& text);

}  // namespace app
