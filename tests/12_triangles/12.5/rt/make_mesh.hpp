#pragma once
#include <rt/mesh.hpp>
#include <rt/polygons.hpp>

namespace answer {

rt::Mesh make_mesh(const rt::Polygons& from);
void add_normals(rt::Mesh& mesh);

}  // namespace answer

namespace rt {

using answer::add_normals;
using answer::make_mesh;

}  // namespace rt
