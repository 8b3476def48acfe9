#pragma once
#include <rt/mesh.hpp>
#include <string>
#include <vector>

namespace rt {

// A surface of polygons with any number of corners (given), as model files describe it. Nothing has
// been checked: a polygon may have too few corners, and an index may be out of range.
struct Polygons {
    std::vector<Vec3> points;
    std::vector<Vec3> normals;  // of any length
    std::vector<Vec2> uvs;
    std::vector<std::vector<Corner>> polygons;
};

// The surface in the bytes of a Wavefront OBJ file. Indices below 0, which count from the end,
// become indices from the start. Groups, materials, lines and curves are ignored. Throws
// std::invalid_argument, which says what is wrong, if a line cannot be read, a polygon has fewer
// than 3 corners or more than 255, or a number is too large.
Polygons read_obj(const std::string& bytes);

}  // namespace rt
