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

// Exercise 12.5. The polygons, cut into triangles that go around the same way, in their order.
// Normals get the length 1. Throws std::invalid_argument, whose message contains "polygon 3" if it
// is the third one, if a polygon has fewer than three corners, or if one of its numbers belongs to
// nothing; -1 stands for no normal and no place, and is right.
// Star: a polygon with a notch is cut so that all triangles face the same way and have an area, if
// a fan from some corner does that. A corner whose normal has length 0 gets none.
inline Mesh make_mesh(const Polygons& from) {
    return rt::todo("12.5", from);
}

// Exercise 12.5. Gives each corner without a normal one that all such corners at its point share:
// the mean of the normals of the triangles around that point, each weighted by its area, of length
// 1. The normals that the mesh has keep their numbers.
// Star: weighted by the triangle's angle at the point instead, so that it does not matter how a
// flat side was cut. Where the sum is zero, the corner stays without. Source: Thürmer and Wüthrich,
// "Computing vertex normals from polygonal facets", 1998.
inline void add_normals(Mesh& mesh) {
    rt::todo("12.5", mesh);
}

}  // namespace rt
