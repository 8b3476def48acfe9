#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <rt/counted.hpp>
#include <rt/polygons.hpp>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace rt {
namespace {

constexpr std::size_t most_corners = 255;  // of a polygon: the library counts them in a byte

// Removes the first word from a line and returns it. Returns an empty text if the line has no word.
std::string_view take_word(std::string_view& line) {
    constexpr std::string_view blanks = " \t\r\v\f";
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

// Whether this is a number with at most three digits in its exponent: the library computes the
// exponent in an int.
bool is_number(std::string_view word) {
    const std::string copy{word};
    char* end = nullptr;
    const std::size_t exponent = std::min(word.find_first_of("eE"), word.size());
    return word.size() - exponent <= 5 && word.find_first_not_of("0123456789+-.eE") == word.npos &&
           std::isfinite(std::strtod(copy.c_str(), &end)) && *end == '\0';
}

// Whether this is a corner: 7, 7/1, 7//3 or 7/1/3, where each number fits into an int and is not 0.
bool is_corner(std::string_view word) {
    for (int part = 0; part < 3; ++part) {
        const std::string_view text = word.substr(0, word.find('/'));
        const bool is_last = text.size() == word.size();
        int number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        const bool is_left_out = part == 1 && text.empty() && !is_last;
        if (!is_left_out &&
            (error != std::errc{} || end != text.data() + text.size() || number == 0))
            return false;
        if (is_last) return true;
        word.remove_prefix(text.size() + 1);
    }
    return false;
}

// The text that the library may read: the lines of points, normals, texture coordinates and
// polygons. All other lines are replaced with empty ones. The library does not check what it reads.
// It takes a word that is not a number for 0, and a polygon of 256 corners for one without corners;
// a line that begins with `t`, a tag, can make it allocate any amount of memory.
std::string checked(std::string_view bytes) {
    std::string lines;
    int number = 0;
    const auto refuse = [&](const std::string& what) {
        throw std::invalid_argument("line " + std::to_string(number) + what);
    };
    while (!bytes.empty()) {
        std::string_view line = bytes.substr(0, bytes.find('\n'));
        bytes.remove_prefix(std::min(line.size() + 1, bytes.size()));
        ++number;
        const std::string_view kind = take_word(line);
        const bool is_polygon = kind == "f";
        if (is_polygon || kind == "v" || kind == "vn" || kind == "vt") {
            lines += kind;
            std::size_t count = 0;
            for (std::string_view word; !(word = take_word(line)).empty(); ++count) {
                if (!(is_polygon ? is_corner(word) : is_number(word)))
                    refuse(" has '" + std::string{word.substr(0, 20)} + "' where a " +
                           (is_polygon ? "corner" : "number") + " belongs");
                (lines += ' ') += word;
            }
            if (is_polygon && (count < 3 || count > most_corners))
                refuse(" has a polygon of " + counted(count, "corner") + ", not 3 to " +
                       std::to_string(most_corners));
            if (!is_polygon && count < (kind == "vt" ? 1 : 3)) refuse(" has too few numbers");
        }
        lines += '\n';
    }
    return lines;
}

// The first line of the library's message.
std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

}  // namespace

Polygons read_obj(const std::string& bytes) {
    std::istringstream in{checked(bytes)};
    tinyobj::attrib_t lists;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    if (!tinyobj::LoadObj(&lists, &shapes, &materials, &warning, &error, &in, nullptr, false,
                          false) ||
        !error.empty())
        throw std::invalid_argument(error.empty() ? "it is broken" : first_line(error));

    Polygons all;
    const auto number = [](tinyobj::real_t x) {
        const auto real = static_cast<Real>(x);
        if (!std::isfinite(real)) throw std::invalid_argument("it has a number that is too large");
        return real;
    };
    for (std::size_t i = 0; i + 2 < lists.vertices.size(); i += 3)
        all.points.push_back({number(lists.vertices[i]), number(lists.vertices[i + 1]),
                              number(lists.vertices[i + 2])});
    for (std::size_t i = 0; i + 2 < lists.normals.size(); i += 3)
        all.normals.push_back(
            {number(lists.normals[i]), number(lists.normals[i + 1]), number(lists.normals[i + 2])});
    for (std::size_t i = 0; i + 1 < lists.texcoords.size(); i += 2)
        all.uvs.push_back({number(lists.texcoords[i]), number(lists.texcoords[i + 1])});
    for (const tinyobj::shape_t& shape : shapes) {
        std::size_t next = 0;
        for (const auto corners : shape.mesh.num_face_vertices) {
            std::vector<Corner> polygon;
            for (unsigned k = 0; k < corners; ++k) {
                const tinyobj::index_t& index = shape.mesh.indices[next++];
                polygon.push_back({index.vertex_index, index.normal_index, index.texcoord_index});
            }
            all.polygons.push_back(std::move(polygon));
        }
    }
    return all;
}

}  // namespace rt
