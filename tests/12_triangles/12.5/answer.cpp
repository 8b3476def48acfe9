#include <answer.hpp>
#include <rt/make_mesh.hpp>

namespace answer EXPORTED {

rt::Mesh make_mesh(const rt::Polygons& from) {
    return rt::make_mesh(from);
}

void add_normals(rt::Mesh& mesh) {
    rt::add_normals(mesh);
}

}  // namespace EXPORTED
