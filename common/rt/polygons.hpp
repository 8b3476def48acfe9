#pragma once
#include <functional>
#include <rt/color.hpp>
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
    // For each polygon the line of the file in which it stands (see `place`), and its material, an
    // index into material_names or -1 for none; empty if it comes from no file.
    std::vector<int> lines = {}, materials = {};
    const char* place = "line";      // "face" if `lines` counts faces, from 0
    std::vector<Color> colors = {};  // of each point, in linear light; empty: none
    std::vector<std::string> material_names = {}, material_files = {};
};

// A material of a material file, with the file's names for its members (given): colors in linear
// light, Kd diffuse, Ks specular, Ke emitted; the exponent Ns of a highlight, the index of
// refraction Ni, the opacity d, the illumination model illum, and the image map_Kd.
struct FileMaterial {
    std::string name;
    Color kd, ks, ke;
    Real ns = 0, ni = 1, d = 1;
    int illum = 0;
    std::string map_kd = {};
    std::vector<std::string> others = {};  // maps that it also names, such as "map_Bump"
};

// Called now and then while a large file is read, with the part that has been read, from 0 to 1.
using Reading = std::function<void(double part)>;

// The surface in the bytes of a Wavefront OBJ file. Indices below 0, which count from the end,
// become indices from the start; a normal that is no number becomes (0, 0, 0). Groups, lines and
// curves are ignored. Throws std::invalid_argument, which names the line and what is
// wrong in it, if a line cannot be read, an index has no entry in its list, a polygon has fewer
// than 3 corners or more than 255, or the polygons make more triangles than `most_triangles`.
Polygons read_obj(const std::string& bytes, std::size_t most_triangles = std::size_t{1} << 30,
                  const Reading& reading = {});

// The surface in the bytes of a PLY file, text or binary. Normals (nx, ny, nz), texture coordinates
// (u, v or s, t) and colors (red, green, blue, in sRGB) belong to points; whatever else the file
// has is skipped. Refuses like read_obj.
Polygons read_ply(const std::string& bytes, std::size_t most_triangles = std::size_t{1} << 30,
                  const Reading& reading = {});

inline constexpr std::size_t most_corners = 255;  // of a polygon in a file

// The materials in the bytes of a material file (MTL). Throws std::invalid_argument, which says
// what is wrong, if a number cannot be used.
std::vector<FileMaterial> read_mtl(const std::string& bytes);

}  // namespace rt
