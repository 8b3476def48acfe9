// The one place where the implementation of the reader of OBJ files is compiled.
#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <cmath>
#include <rt/polygons.hpp>
#include <sstream>
#include <stdexcept>

namespace rt {
namespace {

// The library takes what is no number for 0, so lines of points are looked at first.
void check_numbers(const std::string& bytes) {
    std::istringstream lines{bytes};
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::istringstream words{line};
        std::string kind, word;
        if (!(words >> kind) || (kind != "v" && kind != "vn" && kind != "vt")) continue;
        int count = 0;
        while (words >> word) {
            char* end = nullptr;
            if (!std::isfinite(std::strtod(word.c_str(), &end)) || *end != '\0')
                throw std::invalid_argument("line " + std::to_string(number) + " has '" +
                                            word.substr(0, 20) + "' where a number belongs");
            ++count;
        }
        if (count < (kind == "vt" ? 1 : 3))
            throw std::invalid_argument("line " + std::to_string(number) + " has too few numbers");
    }
}

// The library's words, up to the end of their first line.
std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

}  // namespace

Polygons read_obj(const std::string& bytes) {
    check_numbers(bytes);
    std::istringstream in{bytes};
    tinyobj::attrib_t lists;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    if (!tinyobj::LoadObj(&lists, &shapes, &materials, &warning, &error, &in, nullptr, false,
                          false) ||
        !error.empty())
        throw std::invalid_argument(error.empty() ? "it is broken" : first_line(error));

    Polygons all;
    const auto number = [](tinyobj::real_t x) { return static_cast<Real>(x); };
    for (std::size_t i = 0; i + 2 < lists.vertices.size(); i += 3)
        all.points.push_back({number(lists.vertices[i]), number(lists.vertices[i + 1]),
                              number(lists.vertices[i + 2])});
    for (std::size_t i = 0; i + 2 < lists.normals.size(); i += 3)
        all.normals.push_back(
            {number(lists.normals[i]), number(lists.normals[i + 1]), number(lists.normals[i + 2])});
    for (std::size_t i = 0; i + 1 < lists.texcoords.size(); i += 2)
        all.places.push_back({number(lists.texcoords[i]), number(lists.texcoords[i + 1])});
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
