#pragma once
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/mesh.hpp>
#include <rt/polygons.hpp>
#include <rt/portable.hpp>
#include <rt/todo.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace rt {

// Exercise 12.5. The polygons, cut into triangles that keep the polygons' order and sense of
// rotation. All normals are scaled to length 1. Throws std::invalid_argument if a polygon has fewer
// than three corners, or if an index has no entry in its list; the message contains "polygon 3" if
// it is the third polygon. -1 is allowed and stands for no normal or no texture coordinates.
// Star: a polygon with a notch is cut into a fan from a corner for which all triangles face the
// same way and have an area, if there is such a corner. A normal of length 0 does not count: its
// corner is left without a normal.
inline Mesh make_mesh(const Polygons& from) {
    return rt::todo("12.5", from);
}

// Exercise 12.5. Gives each corner without a normal a new normal, which all such corners at the
// same point share: the mean of the normals of the triangles around the point, each weighted by its
// triangle's area, scaled to length 1. The existing normals keep their indices.
// Star: weight each normal by its triangle's angle at the point instead, so that it does not matter
// how a flat side was cut. If the sum is zero, the corner stays without a normal. Source: Thürmer
// and Wüthrich, "Computing vertex normals from polygonal facets", 1998.
inline void add_normals(Mesh& mesh) {
    rt::todo("12.5", mesh);
}

}  // namespace rt
