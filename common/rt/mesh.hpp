#pragma once
#include <array>
#include <rt/color.hpp>
#include <rt/vec2.hpp>
#include <rt/vec3_type.hpp>
#include <vector>

namespace rt {

// A corner of a triangle, as indices into a mesh's lists. `normal` or `uv` is -1 if the corner
// has none.
struct Corner {
    int point = 0;
    int normal = -1;
    int uv = -1;  // texture coordinates

    friend constexpr bool operator==(const Corner&, const Corner&) = default;
};

// A surface of triangles (given). Points, normals and texture coordinates are stored once, however
// many triangles share them. Seen from outside, the corners of a triangle go around
// counterclockwise.
struct Mesh {
    std::vector<Vec3> points;
    std::vector<Vec3> normals;  // length 1, outward
    std::vector<Vec2> uvs;  // (0, 0) is an image's lower left corner, (1, 1) the upper right one
    std::vector<std::array<Corner, 3>> triangles;
    std::vector<Color> colors = {};  // of each point, in linear light; empty: none
};

}  // namespace rt
