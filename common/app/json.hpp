#pragma once
// Reading JSON files that people write: every error says where it is and what is allowed.
//
// nlohmann::json alone says at which byte it stopped, and which tokens it would have accepted
// there. It does not name the common slip behind the error (a comment, single quotes, one comma too
// many). If an object has a key twice, it silently keeps the last value, and it sets no limit to
// nesting. A value of two bytes, such as "{}" or "1,", takes up to a hundred in memory.

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace app {

inline constexpr std::size_t max_json_bytes = 64 << 20;
inline constexpr int max_json_depth = 16;
// Of keys and values together. A scene of a million plain spheres has ten million, and a scene file
// with whatever contents takes at most 1.4 GiB to read.
inline constexpr std::size_t max_json_values = 12'000'000;

// The value that a text holds. Throws UsageError if the text is not JSON (RFC 8259, so neither
// comments nor NaN) or a number does not fit a double; the message begins with `file`, line and
// column. Also throws UsageError if values are nested deeper than max_json_depth, there are more
// than max_json_values, or an object has a key twice; that message begins with `file` and the
// position.
nlohmann::json parse_json(const std::string& text, const std::string& file);

// An object whose values are texts, for those who otherwise need nothing of the library, which
// takes seconds to compile. texts_in throws as parse_json does, and if a value is no text.
std::string to_json(const std::map<std::string, std::string>& texts);
std::map<std::string, std::string> texts_in(const std::string& text, const std::string& file);

// Where a value stands in a file, as people write it: spheres[3].material, materials["a b"].
std::string path_of_member(const std::string& parent, const std::string& key);
std::string path_of_item(const std::string& parent, std::size_t index);

// What a person wrote, in quotes, and cut off if it is long.
std::string quoted(const std::string& text);

}  // namespace app
