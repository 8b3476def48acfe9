#pragma once
// What a scene file has besides app::Value's numbers, words and lists: vectors, colors, matrices
// and other files. For a value that is not allowed, each function throws app::UsageError, which
// names the file, the position and what is allowed.

#include <app/json.hpp>
#include <app/value.hpp>
#include <array>
#include <filesystem>
#include <rt/color.hpp>
#include <rt/mat4.hpp>
#include <rt/sphere.hpp>
#include <rt/vec3.hpp>
#include <string>

namespace effects {

using app::Range;
using app::Value;
using rt::Color;
using rt::Real;
using rt::Vec3;

// Wide enough for galaxies and atoms, and narrow enough that in float no square overflows.
inline constexpr Range coordinates{-1e9, 1e9}, lengths{1e-9, 1e9}, shares{0, 1}, light{0, 1e6};

inline Real number(const Value& value, Range range) {
    return static_cast<Real>(value.number(range));
}

inline std::array<Real, 3> three(const Value& value, const std::string& wanted, Range range) {
    if (!value.is_list() || value.list("numbers").size() != 3) value.refuse(wanted);
    const Value::List all = value.list("numbers");
    return {number(all[0], range), number(all[1], range), number(all[2], range)};
}

inline Vec3 vec3_within(const Value& value, const std::string& wanted, Range range) {
    const auto [x, y, z] = three(value, wanted, range);
    return {x, y, z};
}
inline Vec3 vec3(const Value& value) {
    return vec3_within(value, "three numbers [x, y, z]", coordinates);
}

// "#rrggbb" as a designer writes it, or linear light [r, g, b].
inline Color color(const Value& value, Range range) {
    const char* const wanted = "a color, \"#rrggbb\" or [r, g, b]";
    if (!value.is_text()) {
        const auto [r, g, b] = three(value, wanted, range);
        return {r, g, b};
    }
    const std::string& hex = value.text();
    const bool fits = hex.size() == 7 && hex[0] == '#' &&
                      hex.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    if (!fits) value.refuse(wanted);
    return rt::from_hex(static_cast<std::uint32_t>(std::stoul(hex.substr(1), nullptr, 16)));
}

// A member that may be left out.
inline Real number(const Value& parent, const std::string& key, Range range, Real otherwise) {
    const auto value = parent.find(key);
    return value ? number(*value, range) : otherwise;
}
inline Vec3 vec3(const Value& parent, const std::string& key, Vec3 otherwise) {
    const auto value = parent.find(key);
    return value ? vec3(*value) : otherwise;
}
inline Color color(const Value& parent, const std::string& key, Color otherwise, Range range) {
    const auto value = parent.find(key);
    return value ? color(*value, range) : otherwise;
}

// The map of a shape that is as large as `plain` and lies there, stretched, then turned around x, y
// and z, as the value's scale and rotate_deg say.
rt::Mat4 read_stretched(const Value& shape, const rt::Sphere& plain);

// Three rows of four numbers; the fourth row of the matrix is always 0 0 0 1.
rt::Mat4 read_matrix(const Value& matrix);

// Fails if the map is singular, or nearly so. `shape` is what it flattens, such as "sphere".
void expect_not_flat(const Value& where, const rt::Mat4& map, const std::string& shape);

// The bytes of a file in the scene's folder, which the value `file` leads to. Files elsewhere are
// not read, so that a scene from someone else cannot reveal them. `kind` is such as "an image".
std::string read_neighbor(const Value& file, const std::string& given,
                          const std::filesystem::path& folder, const std::string& kind,
                          std::size_t most);

}  // namespace effects
